// The BSDF where all surfaces are Lambert surfaces. The same functions as in bsdf_layered.glsl.
// Depends on lambert.glsl and bsdf_sample.glsl.

struct Bsdf {
  vec3 base_color;
};

// Whether light from a single direction can be reflected: what light samples are for.
bool spreads(Bsdf bsdf) {
  return max(bsdf.base_color.r, max(bsdf.base_color.g, bsdf.base_color.b)) > 0.0;
}

// Times the cosine of wi.
vec3 evalBsdf(Bsdf bsdf, vec3 wo, vec3 wi) {
  return evalLambert(bsdf.base_color) * max(wi.z, 0.0);
}

float pdfBsdf(Bsdf bsdf, vec3 wo, vec3 wi) {
  return pdfLambert(wi);
}

// The third random number has no lobe to choose.
BsdfSample sampleBsdf(Bsdf bsdf, vec3 wo, vec3 random) {
  vec3 wi = sampleLambert(vec2(random.x, random.y));
  return BsdfSample(wi, bsdf.base_color, pdfLambert(wi), random.z);
}
