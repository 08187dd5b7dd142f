// The pass that measures by how much the picture has changed: the sums over a square of
// CHANGE_SQUARE x CHANGE_SQUARE pixels of
//   x: the squared relative change of the luminance since it was kept
//   y: its square
//   z: the squared relative change between the two times before
//   w: the luminance
uniform sampler2D uMean;
uniform sampler2D uBlock;
uniform sampler2D uKept;
uniform float uSinceLast;  // 1: since the last time it was kept; 0: since the one before
uniform float uFloor;      // luminance below which a change is no longer relative to the pixel's own

float luminanceAt(vec2 pixel) {
  vec2 at = clamp(pictureAddress(pixel), 0.5 * uPictureStep, 1.0 - 0.5 * uPictureStep);
  return luminance(meanWithBlock(texture2D(uMean, at), texture2D(uBlock, at)).rgb);
}

// What a pixel's change is relative to, squared. A pixel that is brighter than those around it is so
// by chance, or most of the noise is elsewhere: it must not make its own error small.
float yardstick(vec2 pixel, float own) {
  float sum = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) sum += luminanceAt(pixel + vec2(x, y));
  float base = min(own, sum * (1.0 / 9.0));
  return max(base * base + uFloor * uFloor, 1.0e-30);
}

vec4 changeAt(vec2 pixel) {
  vec4 kept = texture2D(uKept, pictureAddress(pixel));
  float own = luminanceAt(pixel);
  float scale = 1.0 / yardstick(pixel, own);
  float change = own - mix(kept.x, kept.y, uSinceLast);
  float before = kept.y - kept.x;
  float squared = change * change * scale;
  return vec4(squared, squared * squared, before * before * scale, own);
}

void main() {
  vec2 first = (pixelCenter() - 0.5) * float(CHANGE_SQUARE) + 0.5;
  vec4 sums = vec4(0.0);
  for (int y = 0; y < CHANGE_SQUARE; ++y)
    for (int x = 0; x < CHANGE_SQUARE; ++x) {
      vec2 pixel = first + vec2(x, y);
      vec2 at = pictureAddress(pixel);
      // A square may stand over the picture's edge.
      if (at.x < 1.0 && at.y < 1.0) sums += changeAt(pixel);
    }
  writeTexel(sums);
}
