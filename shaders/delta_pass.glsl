// The pass from hit records on mirrors and smooth glass to what they show: the same rays as those of
// the trace pass. All other paths are left out, and end where the target has been cleared.
void main() {
  vec2 pixel = pixelCenter();
  vec4 random = samplePoint(pixel);
  HitRecord start;
  bool live = readRecord(pixel, start);
  PathRay ray = scatteredRay(start, !live, random);
  Surface surface = surfaceOf(start);
  vec3 wo = outgoing(frameAround(surface.normal), start.direction);
  ray.wanted = ray.wanted && ray.pdf >= PDF_DELTA && !spreads(fetchBsdf(surface, wo));
#if SHADOW_CATCHER
  ray.wanted = ray.wanted && !isShadowCatcher(start);
#endif
  Hit hit = followRay(ray);
  bool goes_on = goesOn(ray, hit);
  if (!goes_on) discard;
  vec4 rounding = vec4(ray.random, random.w, lowBits(ray.random), lowBits(random.w));
  writeRecord(recordOf(ray, hit, 1.0), goes_on, rounding);
}
