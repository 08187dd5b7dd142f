// A clear coat over everything else: one more boundary, of IOR 1.5, without colour. What lies below
// gets what the coat does not reflect. Depends on fresnel.glsl, ggx.glsl, gloss.glsl and mirror.glsl.
// Directions are in a frame with the normal along +z, wo above.

struct Clearcoat {
  float strength;   // in [0, 1]
  float roughness;  // 0: exact mirror
  vec2 albedo;      // for wo; see gloss_albedo.glsl
};

const float CLEARCOAT_REFLECTANCE = 0.04;

bool isSmooth(Clearcoat coat) {
  return coat.roughness == 0.0;
}

float alphaOf(Clearcoat coat) {
  return max(coat.roughness * coat.roughness, 1.0e-6);
}

// What it reflects of the light into all directions.
float clearcoatAlbedo(Clearcoat coat, vec3 wo) {
  if (isSmooth(coat)) return coat.strength * fresnelSchlick(vec3(CLEARCOAT_REFLECTANCE), 1.0, wo.z).x;
  return coat.strength * glossAlbedo(vec3(CLEARCOAT_REFLECTANCE), 1.0, coat.albedo).x;
}

// Times the cosine of wi. Of a smooth coat, nothing: only a single direction has it.
float evalClearcoat(Clearcoat coat, vec3 wo, vec3 wi) {
  if (isSmooth(coat)) return 0.0;
  return coat.strength *
         evalGloss(wo, wi, alphaOf(coat), vec3(CLEARCOAT_REFLECTANCE), 1.0, coat.albedo).x;
}

float pdfClearcoat(Clearcoat coat, vec3 wo, vec3 wi) {
  return isSmooth(coat) ? 0.0 : pdfGloss(wo, wi, alphaOf(coat));
}

// Of a rough coat, may be the zero vector, as sampleGloss says.
vec3 sampleClearcoat(Clearcoat coat, vec3 wo, vec2 random) {
  return isSmooth(coat) ? mirrorDirection(wo) : sampleGloss(wo, alphaOf(coat), random);
}
