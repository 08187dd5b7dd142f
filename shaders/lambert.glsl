// The Lambert surface: reflects the same radiance in all directions. Depends on constants.glsl and
// warp.glsl. Directions are in a frame with the normal along +z, on the side that is lit.

vec3 evalLambert(vec3 base_color) {
  return base_color / PI;
}

float pdfLambert(vec3 wi) {
  return max(wi.z, 0.0) / PI;
}

// The sampled direction's f * cos / pdf is base_color.
vec3 sampleLambert(vec2 random) {
  return sampleCosineHemisphere(random);
}
