// What a path that has met a triangle adds to its pixel. Emission found there, and one sample of the
// light that arrives. `last` is 1 where no further ray will look for emission, else 0.

// Marks a pixel whose path is not known. It stays negative whatever is added.
const vec3 RADIANCE_UNKNOWN = vec3(-1.0e30);

vec3 emittedRadiance(HitRecord record, Surface surface) {
#if TRIANGLE_LIGHTS
  Emission emission = fetchEmission(surface.material);
  bool emits = record.back < 0.5 || emission.both_sides;
  return emits ? emission.radiance : vec3(0.0);
#else
  return vec3(0.0);
#endif
}

#if TRIANGLE_LIGHTS || ENVIRONMENT
vec3 reflectedRadiance(HitRecord record, Surface surface, vec4 random, bool wanted,
                       float last) {
  vec3 origin = leaveSurface(surface.position, surface.geometric, surface.error_scale);
  LightSample light = sampleLight(surface, origin, random);
  float cosine = dot(light.direction, surface.normal);
  vec3 base_color = fetchBaseColor(surface.material);
  wanted = wanted && light.possible && cosine > 0.0;
  wanted = wanted && max(base_color.r, max(base_color.g, base_color.b)) > 0.0;
  float visible = visibility(origin, light.to, light.far, wanted);
  if (!wanted) return vec3(0.0);
  if (visible < 0.0) return RADIANCE_UNKNOWN;
  float weight = last > 0.5 ? 1.0 : powerHeuristic(light.pdf, max(cosine, 0.0) / PI);
  return evalLambert(base_color) * light.radiance * (visible * weight * max(cosine, 0.0) / light.pdf);
}
#endif

vec3 radianceOf(HitRecord record, bool ended, vec4 random, float last) {
  bool wanted = !ended && record.triangle != TRIANGLE_NONE;
  bool hit = wanted && record.triangle < TRIANGLE_UNKNOWN;
  Surface surface = surfaceOf(record);
  vec3 radiance = emittedRadiance(record, surface) * record.weight;
#if TRIANGLE_LIGHTS || ENVIRONMENT
  radiance += reflectedRadiance(record, surface, random, hit, last);
#endif
  if (record.triangle == TRIANGLE_UNKNOWN) radiance = RADIANCE_UNKNOWN;
  return wanted ? record.throughput * radiance : vec3(0.0);
}
