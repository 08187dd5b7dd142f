// Of several light samples one is taken, in proportion to what the surface reflects of it, and stands
// for all: resampled importance sampling (Talbot, Cline and Egbert 2005). Shadow rays then go where
// much light comes from as seen by this surface, and a candidate costs a few fetches where a shadow
// ray costs hundreds.

#if TRIANGLE_LIGHTS || ENVIRONMENT || PUNCTUAL_LIGHTS
const int LIGHT_CANDIDATES = 8;

// Candidates are evenly spread over what chooses the light, and by the R3 sequence (Roberts 2018)
// over the rest.
vec4 candidatePoint(vec4 random, float index) {
  vec3 rest = index * vec3(0.8191725134, 0.6710436067, 0.5497004779);
  return fract(random + vec4(rest.xy, index / float(LIGHT_CANDIDATES), rest.z));
}

Reflection sampleReflection(Surface surface, Frame frame, Bsdf bsdf, vec3 wo, vec3 origin,
                            vec4 random, bool alone) {
  // Independent of the candidates, which ask for few of the bits.
  float choice = lowBits(random.w, random.z);
  Reflection chosen = Reflection(vec3(1.0), 1.0, vec3(0.0), false, false);
  float sum = 0.0;
  for (int i = 0; i < LIGHT_CANDIDATES; ++i) {
    LightSample light = sampleLight(surface, frame, origin, candidatePoint(random, float(i)));
    Reflection candidate = reflectionOf(light, surface, frame, bsdf, wo, alone);
    vec3 radiance = candidate.radiance;
    float largest = max(radiance.r, max(radiance.g, radiance.b));
    bool counts = candidate.possible && largest > 0.0;
    sum += counts ? largest : 0.0;
    float chance = counts ? largest / sum : 0.0;
    if (choice < chance) {
      chosen = candidate;
      chosen.radiance /= largest;
      choice /= chance;
    } else {
      choice = (choice - chance) / max(1.0 - chance, 1.0e-7);
    }
    choice = clamp(choice, 0.0, 0.99999994);
  }
  chosen.radiance *= sum / float(LIGHT_CANDIDATES);
  return chosen;
}
#endif
