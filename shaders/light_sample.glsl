// One sample of the light that arrives at a surface. Dispatches on the scene's effects.
struct LightSample {
  vec3 to;         // from the surface towards the light;
  float far;       // so many times `to` is what a shadow ray has to pass
  vec3 direction;  // unit
  vec3 radiance;
  float pdf;       // per solid angle, of choosing this light and this direction
  bool possible;   // whether any light can arrive
  bool by_chance;  // whether a ray may also come upon the light
};

#if TRIANGLE_LIGHTS
// The light arrives at the surface itself: the shadow ray starts a little above it, from where light
// that grazes the surface would seem to come at another angle.
LightSample sampleTriangleLight(Surface surface, vec3 origin, float choice, vec2 random) {
  float triangle = chooseLight(choice);
  TriangleData data = fetchTriangle(triangle);
  Emission emission = fetchEmission(data.material);
  vec3 normal = normalize(cross(data.v1 - data.v0, data.v2 - data.v0));
  vec2 uv = sampleTriangle(random);
  vec3 point = interpolate(data.v0, data.v1, data.v2, uv);
  vec3 to = point - surface.position;
  float distance2 = max(dot(to, to), 1.0e-30);
  vec3 direction = to * inversesqrt(distance2);
  float cosine = -dot(direction, normal);
  if (emission.both_sides) cosine = abs(cosine);
  vec3 facing = dot(normal, to) > 0.0 ? -normal : normal;
#if EMISSION_TEXTURES
  emission.radiance *= lookUpColor(data.material, EMISSION_TEXTURE,
                                   interpolatedTexcoords(fetchTexcoords(triangle), uv)).rgb;
#endif
#if ALPHA
  emission.radiance *= opacityAt(triangle, data.material, uv);
#endif
  vec3 end = leaveSurface(point, facing, errorScale(data.v0, data.v1, data.v2));
  return LightSample(end - origin, 1.0, direction, emission.radiance,
                     emission.density * distance2 / max(cosine, 1.0e-7), cosine > 1.0e-7, true);
}
#endif

#if ENVIRONMENT
LightSample sampleEnvironmentLight(Frame frame, vec4 random) {
  EnvironmentSample sky = sampleEnvironment(frame, random);
  return LightSample(sky.direction, FAR_AWAY, sky.direction, sky.radiance, sky.pdf, sky.pdf > 0.0,
                     true);
}
#endif

#if PUNCTUAL_LIGHTS
LightSample samplePunctual(Surface surface, vec3 origin, float choice) {
  PunctualSample light = samplePunctualLight(surface.position, choice);
  vec3 to = light.far > 1.0 ? light.to : light.to + surface.position - origin;
  return LightSample(to, light.far, light.direction, light.irradiance, light.probability, true,
                     false);
}
#endif

#if TRIANGLE_LIGHTS || PUNCTUAL_LIGHTS || ENVIRONMENT
// Each kind of light gets its share of the samples, see lightShares. What chooses among the kinds is
// stretched to a random number again for the one that needs four of them.
LightSample sampleLight(Surface surface, Frame frame, vec3 origin, vec3 shares, vec4 random) {
#if TRIANGLE_LIGHTS
  LightSample light = sampleTriangleLight(surface, origin, random.z, random.xy);
  light.pdf *= shares.y;
#endif
#if PUNCTUAL_LIGHTS
  LightSample punctual = samplePunctual(surface, origin, random.z);
  punctual.pdf *= shares.z;
#if TRIANGLE_LIGHTS
  if (random.w >= 1.0 - shares.z) light = punctual;
#else
  LightSample light = punctual;
#endif
#endif
#if ENVIRONMENT
  bool to_sky = random.w < shares.x;
  float left = to_sky ? random.w / shares.x : 0.0;
  LightSample sky = sampleEnvironmentLight(frame, vec4(random.xyz, left));
  sky.pdf *= shares.x;
#if TRIANGLE_LIGHTS || PUNCTUAL_LIGHTS
  if (to_sky) light = sky;
#else
  LightSample light = sky;
#endif
#endif
  return light;
}
#endif
