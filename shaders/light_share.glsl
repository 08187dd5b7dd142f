// How light samples are divided among the kinds of light that a scene has: shares that sum to one,
// of the environment, of triangles that emit, and of lights without triangles.
uniform vec3 uLightShares;
uniform vec3 uLightSharesAlone;  // where no ray will come upon the light by chance

vec3 lightShares(bool alone) {
  return alone ? uLightSharesAlone : uLightShares;
}

// What a light sample is worth against a ray that comes upon the same light: one that was chosen among
// candidates is worth more.
#if MANY_LIGHTS
const float LIGHT_SAMPLE_WORTH = 2.0;
#else
const float LIGHT_SAMPLE_WORTH = 1.0;
#endif
