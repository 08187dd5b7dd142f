// The light that arrives at a shadow catcher where the camera sees it, from one sample of the lights: y
// as it is, z as it would be if nothing stood in its way. Their means make the shadow: 1 - y / z.
vec3 caughtLight(HitRecord record, vec4 random, bool wanted) {
#if TRIANGLE_LIGHTS || ENVIRONMENT || PUNCTUAL_LIGHTS
  Surface surface = surfaceOf(record);
  vec3 origin = leaveSurface(surface.position, surface.geometric, surface.error_scale);
  Frame frame = frameAround(surface.normal);
  LightSample light = sampleLight(surface, frame, origin, lightShares(true), random);
  float cosine = dot(light.direction, surface.normal);
  wanted = wanted && light.possible && cosine > 0.0;
  float visible = visibility(origin, light.to, light.far, wanted);
  if (!wanted) return vec3(0.0);
  if (visible < 0.0) return RADIANCE_UNKNOWN;
  float arriving = luminance(light.radiance) * cosine / light.pdf;
  return vec3(0.0, arriving * visible, arriving);
#else
  return vec3(0.0);
#endif
}
