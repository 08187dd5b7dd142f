// The escape pass: the light that paths bring which have left the scene. Where draws are limited to live
// paths it marks those that have ended, and draws nothing else.
uniform sampler2D uRecord;

#if ENVIRONMENT
vec3 escapedRadiance(vec4 texel) {
  HitRecord record = decodeHitRecord(texel);
  bool escaped = !isEnded(texel) && record.triangle == TRIANGLE_NONE;
  vec3 radiance = record.throughput * (environmentRadiance(record.direction) * record.weight);
  return escaped ? radiance : vec3(0.0);
}
#else
vec3 escapedRadiance(vec4 texel) {
  return vec3(0.0);
}
#endif

void main() {
  vec2 pixel = pixelCenter();
  vec4 texel = texture2D(uRecord, pictureAddress(pixel));
#if LIVE_ONLY
  if (isOnSurface(texel)) discard;
#endif
  addRadiance(escapedRadiance(texel), pixel);
}
