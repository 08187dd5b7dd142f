// The hit record: what one bounce leaves for the next, in four floats.
//
//   channel  sign        mantissa, 23 bits              exponent, 7 bits
//   x        back side   triangle                       throughput red
//   y        -           u, 16 bits; green, 7 bits      throughput exponent
//   z        -           v, 16 bits; blue, 7 bits       weight of the emission
//   w        -           direction x, 15; y high, 8     direction y low
//
// Position, normals and material follow from the triangle and u, v. Fields that the mean of the
// picture depends on are rounded stochastically, so that their expected value is exact. A texel of
// zeros is a path that has ended.

struct HitRecord {
  float triangle;   // index, or one of the two below
  float back;       // 1 if the path came to the triangle's back side, else 0
  vec2 uv;          // barycentric weights of vertices 1 and 2
  vec3 direction;   // unit, in which the path arrived
  vec3 throughput;  // of the path up to here
  float weight;     // of the emission found here, against sampling it as a light; in [0, 1]
};

// The path has left the scene.
const float TRIANGLE_NONE = 8388607.0;
// The traversal was cut short: nothing is known of this path.
const float TRIANGLE_UNKNOWN = 8388606.0;

const float UV_STEPS = 65536.0;
const float COLOR_STEPS = 128.0;
const float DIRECTION_STEPS = 32768.0;

// Weaker paths than this are ended: their light is far below the last bit of any picture.
const float LEAST_THROUGHPUT = 1.0e-12;

bool isEnded(vec4 record) {
  return record.x == 0.0;
}

// Cells of a grid over the triangle, rounded so that the mean of their centres is exact. Centres
// are never on an edge, where the next ray could start outside a closed mesh.
vec2 uvCell(vec2 uv, vec2 random) {
  vec2 cell = clamp(floor(uv * UV_STEPS - 0.5 + random), 0.0, UV_STEPS - 2.0);
  float excess = max(cell.x + cell.y - (UV_STEPS - 2.0), 0.0);
  float from_x = min(floor(0.5 * excess + 0.5), cell.x);
  return vec2(cell.x - from_x, cell.y - (excess - from_x));
}

vec2 uvOfCell(vec2 cell) {
  return (cell + 0.5) * (1.0 / UV_STEPS);
}

// The exponent with which the largest channel lies in [63.5, 127]: one that is rounded up still
// fits into seven bits.
float throughputExponent(float largest) {
  float exponent = splitFields(vec4(largest)).exponent.x + 17.0;
  return largest > 127.0 * powerOfTwo(vec4(exponent)).x ? exponent + 1.0 : exponent;
}

// `random` has four independent values in [0, 1). The throughput's channels share one: they are
// never multiplied with each other.
vec4 encodeHitRecord(HitRecord record, vec4 random) {
  float largest = max(record.throughput.x, max(record.throughput.y, record.throughput.z));
  if (!(largest >= LEAST_THROUGHPUT)) return vec4(0.0);

  float exponent = throughputExponent(largest);
  // 127 and a random number just below 1 may add up to 128, which would spill into the next field.
  vec3 color = min(floor(record.throughput * powerOfTwo(vec4(-exponent)).x + random.x),
                   COLOR_STEPS - 1.0);
  float weight = min(floor(clamp(record.weight, 0.0, 1.0) * (COLOR_STEPS - 1.0) + random.y),
                     COLOR_STEPS - 1.0);
  vec2 cell = uvCell(record.uv, vec2(random.z, random.w));
  vec2 square = encodeOctahedral(record.direction) * 0.5 + 0.5;
  vec2 direction = clamp(floor(square * DIRECTION_STEPS), 0.0, DIRECTION_STEPS - 1.0);
  float direction_high = floor(direction.y * (1.0 / COLOR_STEPS));

  vec4 mantissa = vec4(record.triangle,
                       cell.x * COLOR_STEPS + color.y,
                       cell.y * COLOR_STEPS + color.z,
                       direction.x * 256.0 + direction_high);
  vec4 code = vec4(color.x, exponent + 64.0, weight, direction.y - direction_high * COLOR_STEPS);
  vec4 record_texel = joinFields(FloatFields(mantissa, code - 64.0));
  float side = record.back > 0.5 ? -1.0 : 1.0;
  return vec4(side * record_texel.x, record_texel.y, record_texel.z, record_texel.w);
}

// Not for a record that isEnded.
HitRecord decodeHitRecord(vec4 record) {
  FloatFields fields = splitFields(abs(record));
  vec4 code = fields.exponent + 64.0;
  vec2 cell = floor(vec2(fields.mantissa.y, fields.mantissa.z) * (1.0 / COLOR_STEPS));
  vec2 green_blue = vec2(fields.mantissa.y, fields.mantissa.z) - cell * COLOR_STEPS;
  float direction_x = floor(fields.mantissa.w * (1.0 / 256.0));
  float direction_y = (fields.mantissa.w - direction_x * 256.0) * COLOR_STEPS + code.w;
  vec2 square = (vec2(direction_x, direction_y) + 0.5) * (1.0 / DIRECTION_STEPS);
  float scale = powerOfTwo(vec4(code.y - 64.0)).x;
  return HitRecord(fields.mantissa.x,
                   record.x < 0.0 ? 1.0 : 0.0,
                   uvOfCell(cell),
                   decodeOctahedral(square * 2.0 - 1.0),
                   vec3(code.x, green_blue.x, green_blue.y) * scale,
                   code.z * (1.0 / (COLOR_STEPS - 1.0)));
}
