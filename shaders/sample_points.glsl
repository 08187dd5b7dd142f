// Low-discrepancy points without integers: the CPU computes the point of this sample and these
// dimensions, and every pixel shifts it, modulo one, by an offset of its own (Cranley and Patterson
// 1976). uOffsets is a square of random offsets that is repeated over the picture; each repetition
// is read from another place in it, and so is each set of dimensions. The four pixels of every
// square of two by two take a point each, of sequences that are scrambled differently: how well a
// sequence happens to be scrambled would else show in the whole picture at once.
uniform sampler2D uOffsets;
uniform vec4 uPoint[POINT_GROUPS];
uniform vec4 uOffsetsShift;  // where these dimensions begin; how far repetitions are moved

vec4 shiftedPoint(vec2 pixel, vec4 point, vec4 offsets_shift) {
  vec2 repetition = floor(pixel * (1.0 / OFFSETS_SIZE));
  vec2 at = pixel + offsets_shift.xy + repetition * offsets_shift.zw;
  return fract(point + texture2D(uOffsets, at * (1.0 / OFFSETS_SIZE)));
}

// Of the points of the four groups, a pixel's own. They are multiples of 2^-23, so no sum rounds, and
// what is between them is the same for all pixels.
vec4 ownPoint(vec2 pixel, vec4 first, vec4 right, vec4 above, vec4 both) {
  vec2 odd = 2.0 * fract(0.5 * pixel) - 0.5;
  return first + odd.x * (right - first) +
         odd.y * ((above - first) + odd.x * ((both - above) - (right - first)));
}

vec4 samplePoint(vec2 pixel) {
  vec4 point = ownPoint(pixel, uPoint[0], uPoint[1], uPoint[2], uPoint[3]);
  return shiftedPoint(pixel, point, uOffsetsShift);
}

// More numbers from one, for rounding only: what is below its first twelve bits.
float lowBits(float random) {
  return fract(random * 4096.0);
}

// The same of two numbers together, twice as fine: each has eleven such bits.
float lowBits(float first, float second) {
  return lowBits(first) + lowBits(second) * (1.0 / 2048.0);
}
