// What a path that has met a triangle adds to its pixel. Emission found there, and one sample of the
// light that arrives. `last` is 1 where no further ray will look for emission but in sharp directions,
// 2 where moreover no light is sampled, else 0.

// Marks a pixel whose path is not known. It stays negative whatever is added.
const vec3 RADIANCE_UNKNOWN = vec3(-1.0e30);

#if TRIANGLE_LIGHTS || ENVIRONMENT || PUNCTUAL_LIGHTS
vec3 reflectedRadiance(HitRecord record, Surface surface, vec4 random, bool wanted,
                       float last) {
  vec3 origin = leaveSurface(surface.position, surface.geometric, surface.error_scale);
  Frame frame = frameAround(surface.normal);
  vec3 wo = outgoing(frame, record.direction);
  Bsdf bsdf = fetchBsdf(surface, wo);
  Reflection reflection = sampleReflection(surface, frame, bsdf, wo, origin, random, last > 0.5);
#if ROUGH_GLASS
  if (reflection.behind) {
    vec3 behind = passSurface(surface);
    reflection.to += origin - behind;
    origin = behind;
  }
#endif
  wanted = wanted && reflection.possible && spreads(bsdf);
  float visible = visibility(origin, reflection.to, reflection.far, wanted);
  if (!wanted) return vec3(0.0);
  if (visible < 0.0) return RADIANCE_UNKNOWN;
  return visible * reflection.radiance;
}
#endif

vec3 radianceOf(HitRecord record, bool ended, vec4 random, float last) {
  bool wanted = !ended && record.triangle != TRIANGLE_NONE;
  bool hit = wanted && record.triangle < TRIANGLE_UNKNOWN;
  Surface surface = surfaceOf(record);
  vec3 radiance = emittedRadiance(record, surface) * record.weight;
#if TRIANGLE_LIGHTS || ENVIRONMENT || PUNCTUAL_LIGHTS
  radiance += reflectedRadiance(record, surface, random, hit && last < 1.5, last);
#endif
  if (record.triangle == TRIANGLE_UNKNOWN) radiance = RADIANCE_UNKNOWN;
  return wanted ? record.throughput * radiance : vec3(0.0);
}
