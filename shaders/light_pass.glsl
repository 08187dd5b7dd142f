// The light pass: hit record to radiance.
uniform float uLastSurface;  // see light.glsl

void main() {
  vec2 pixel = pixelCenter();
  HitRecord record;
  bool live = readRecord(pixel, record);
  vec4 random = samplePoint(pixel);
#if TRANSPARENT_BACKGROUND
  bool hit = live && record.triangle < TRIANGLE_UNKNOWN;
  vec4 sum = vec4(0.0, 0.0, 0.0, hit && isSeen() ? SEEN_SURFACE : 0.0);
#if SHADOW_CATCHER
  bool caught = hit && isShadowCatcher(record);
  vec3 light = caughtLight(record, random, caught);
  if (caught) sum = vec4(light, SEEN_CATCHER);
  live = live && !caught;
#endif
  sum.rgb += radianceOf(record, !live, random, uLastSurface);
  addToSample(sum, pixel);
#else
#if PATH_LENGTH
  addToSample(vec4(radianceOf(record, !live, random, uLastSurface), live ? 1.0 : 0.0), pixel);
#else
  addRadiance(radianceOf(record, !live, random, uLastSurface), pixel);
#endif
#endif
}
