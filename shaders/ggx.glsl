// The GGX distribution of microfacets: Walter et al. 2007, "Microfacet Models for Refraction through
// Rough Surfaces", with Smith's height-correlated masking. `alpha` is the roughness squared, > 0.
// Directions are in a frame with the normal along +z. Depends on constants.glsl.

// Density of microfacet normals. Written with x and y, which keep their digits where alpha is small
// and z is nearly 1.
float ggxDistribution(vec3 normal, float alpha) {
  float slope2 = (normal.x * normal.x + normal.y * normal.y) / (alpha * alpha);
  float d = slope2 + normal.z * normal.z;
  return 1.0 / (PI * alpha * alpha * d * d);
}

// Heitz 2014, "Understanding the Masking-Shadowing Function", equation 72.
float ggxLambda(vec3 w, float alpha) {
  float tangent2 = (w.x * w.x + w.y * w.y) / max(w.z * w.z, 1.0e-12);
  return 0.5 * (sqrt(1.0 + alpha * alpha * tangent2) - 1.0);
}

float ggxMasking(vec3 w, float alpha) {
  return 1.0 / (1.0 + ggxLambda(w, alpha));
}

// Both directions on the same side; for a transmitted one, give its mirror image.
float ggxMaskingShadowing(vec3 wo, vec3 wi, float alpha) {
  return 1.0 / (1.0 + ggxLambda(wo, alpha) + ggxLambda(wi, alpha));
}

// A microfacet normal, as often as it is seen from wo: Dupuy and Benyoub 2023, "Sampling Visible
// GGX Normals with Spherical Caps".
vec3 sampleGgxNormal(vec3 wo, float alpha, vec2 random) {
  vec3 stretched = normalize(vec3(alpha * wo.x, alpha * wo.y, wo.z));
  float angle = 2.0 * PI * random.x;
  float z = 1.0 - random.y * (1.0 + stretched.z);
  float radius = sqrt(clamp(1.0 - z * z, 0.0, 1.0));
  vec3 seen = vec3(radius * cos(angle), radius * sin(angle), z) + stretched;
  return normalize(vec3(alpha * seen.x, alpha * seen.y, max(seen.z, 1.0e-7)));
}

// Its density, per solid angle of the normal.
float pdfGgxNormal(vec3 wo, vec3 normal, float alpha) {
  return ggxMasking(wo, alpha) * max(dot(wo, normal), 0.0) * ggxDistribution(normal, alpha) /
         max(wo.z, 1.0e-7);
}

// The density of the direction that wo is reflected into, where the microfacet's normal is halfway
// between the two. Not by way of the normal's density: the cosine between wo and the normal cancels,
// and has no digits left where the two directions are nearly opposite.
float pdfGgxReflection(vec3 wo, vec3 normal, float alpha) {
  return ggxMasking(wo, alpha) * ggxDistribution(normal, alpha) / (4.0 * max(wo.z, 1.0e-7));
}
