// Of several light samples one is taken, in proportion to what the surface reflects of it, and stands
// for all: resampled importance sampling (Talbot, Cline and Egbert 2005). Shadow rays then go where
// much light comes from as seen by this surface, and a candidate costs a few fetches where a shadow
// ray costs hundreds.

#if TRIANGLE_LIGHTS || ENVIRONMENT || PUNCTUAL_LIGHTS
const int LIGHT_CANDIDATES = 8;

// Of the choices, that does not ask how much light a candidate brings: a bright light that is hidden
// would else put out all others.
const float EVEN_SHARE = 1.0 / float(LIGHT_CANDIDATES);

// Where the kind of light that a random number chooses begins and ends.
vec2 kindAround(float random, vec3 shares) {
  if (random < shares.x) return vec2(0.0, shares.x);
  if (random < 1.0 - shares.z) return vec2(shares.x, 1.0 - shares.z);
  return vec2(1.0 - shares.z, 1.0);
}

// Candidates are of one kind, so that the sun behind a roof is not preferred to the lamp under it.
// They are evenly spread over what chooses the light, and by the R3 sequence (Roberts 2018) over the
// rest.
vec4 candidatePoint(vec4 random, float index, vec2 kind) {
  vec3 rest = index * vec3(0.8191725134, 0.6710436067, 0.5497004779);
  float extent = kind.y - kind.x;
  float within = fract((random.w - kind.x) / extent + rest.z);
  return vec4(fract(random.xyz + vec3(rest.xy, index / float(LIGHT_CANDIDATES))),
              kind.x + within * extent);
}

Reflection sampleReflection(Surface surface, Frame frame, Bsdf bsdf, vec3 wo, vec3 origin,
                            vec4 random, bool alone) {
  // One in eight samples in a row, and independent of the candidates: theirs are the same eight z
  // wherever among the eighths the first is.
  bool even = random.z < EVEN_SHARE;
  float choice = lowBits(random.w, random.z);
  vec3 shares = lightShares(alone);
  vec2 kind = kindAround(random.w, shares);
  Reflection chosen = Reflection(vec3(1.0), 1.0, vec3(0.0), false, false);
  float chosen_weight = 1.0;
  float sum = 0.0;
  float count = 0.0;
  for (int i = 0; i < LIGHT_CANDIDATES; ++i) {
    vec4 point = candidatePoint(random, float(i), kind);
    LightSample light = sampleLight(surface, frame, origin, shares, point);
    Reflection candidate = reflectionOf(light, surface, frame, bsdf, wo, alone);
    vec3 radiance = candidate.radiance;
    float weight = candidate.possible ? max(radiance.r, max(radiance.g, radiance.b)) : 0.0;
    if (weight > 0.0) {
      sum += weight;
      count += 1.0;
      float chance = even ? 1.0 / count : weight / sum;
      if (choice < chance) {
        chosen = candidate;
        chosen_weight = weight;
        choice /= chance;
      } else {
        choice = (choice - chance) / max(1.0 - chance, 1.0e-7);
      }
      choice = clamp(choice, 0.0, 0.99999994);
    }
  }
  float probability = (1.0 - EVEN_SHARE) * chosen_weight / max(sum, 1.0e-30) +
                      EVEN_SHARE / max(count, 1.0);
  chosen.radiance /= float(LIGHT_CANDIDATES) * probability;
  return chosen;
}
#endif
