// The escape pass: paths that have left the scene bring their light and end. Where draws are limited to
// live paths this pass marks all that have ended, and draws nothing else.
void main() {
  vec2 pixel = pixelCenter();
  HitRecord record;
  bool ended = !readRecord(pixel, record);
  vec3 radiance = vec3(0.0);
#if ENVIRONMENT
  bool escaped = !ended && record.triangle == TRIANGLE_NONE;
  if (escaped) radiance = escapedRadiance(record);
#if TRANSPARENT_BACKGROUND
  if (isSeen()) radiance = vec3(0.0);
#endif
  ended = ended || escaped;
#endif
#if LIVE_ONLY
  if (!ended) discard;
#endif
  addRadiance(radiance, pixel);
}
