// The escape pass: paths that have left the scene bring their light and end. Where draws are limited to
// live paths this pass marks all that have ended, and draws nothing else.
uniform sampler2D uRecord;

void main() {
  vec2 pixel = pixelCenter();
  vec4 texel = texture2D(uRecord, pictureAddress(pixel));
  bool ended = isEnded(texel);
  vec3 radiance = vec3(0.0);
#if ENVIRONMENT
  HitRecord record = decodeHitRecord(texel);
  bool escaped = !ended && record.triangle == TRIANGLE_NONE;
  if (escaped) radiance = escapedRadiance(record);
  ended = ended || escaped;
#endif
#if LIVE_ONLY
  if (!ended) discard;
#endif
  addRadiance(radiance, pixel);
}
