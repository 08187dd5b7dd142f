// One light sample is taken as it comes.

#if TRIANGLE_LIGHTS || ENVIRONMENT || PUNCTUAL_LIGHTS
Reflection sampleReflection(Surface surface, Frame frame, Bsdf bsdf, vec3 wo, vec3 origin,
                            vec4 random, bool alone) {
  LightSample light = sampleLight(surface, frame, origin, lightShares(alone), random);
  return reflectionOf(light, surface, frame, bsdf, wo, alone);
}
#endif
