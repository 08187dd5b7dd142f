// What a path that has met a triangle adds to its pixel. Emission found there, and one sample of the
// light that arrives. `last` is 1 where no further ray will look for emission, 2 where moreover no
// light is sampled, else 0.

// Marks a pixel whose path is not known. It stays negative whatever is added.
const vec3 RADIANCE_UNKNOWN = vec3(-1.0e30);

#if TRIANGLE_LIGHTS || ENVIRONMENT || PUNCTUAL_LIGHTS
vec3 reflectedRadiance(HitRecord record, Surface surface, vec4 random, bool wanted,
                       float last) {
  vec3 origin = leaveSurface(surface.position, surface.geometric, surface.error_scale);
  Frame frame = frameAround(surface.normal);
  LightSample light = sampleLight(surface, frame, origin, random);
  vec3 wo = outgoing(frame, record.direction);
  vec3 wi = toFrame(frame, light.direction);
  Bsdf bsdf = fetchBsdf(surface, wo);
#if ROUGH_GLASS
  if (wi.z < 0.0) {
    vec3 behind = passSurface(surface);
    light.to += origin - behind;
    origin = behind;
    wanted = wanted && dot(light.direction, surface.geometric) < 0.0;
  }
#else
  wanted = wanted && wi.z > 0.0;
#endif
  wanted = wanted && light.possible && spreads(bsdf);
  float visible = visibility(origin, light.to, light.far, wanted);
  if (!wanted) return vec3(0.0);
  if (visible < 0.0) return RADIANCE_UNKNOWN;
  bool alone = last > 0.5 || !light.by_chance;
  float weight = alone ? 1.0 : powerHeuristic(light.pdf, pdfBsdf(bsdf, wo, wi));
  return evalBsdf(bsdf, wo, wi) * light.radiance * (visible * weight / light.pdf);
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
