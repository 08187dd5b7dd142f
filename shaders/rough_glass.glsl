// A rough boundary between two dielectrics: Walter et al. 2007, "Microfacet Models for Refraction
// through Rough Surfaces", section 5. Radiance is not scaled by the square of the index of
// refraction where it enters: it is scaled back where it leaves. What is lost because light meets only
// one microfacet is added back evenly: `albedo` is what is left. Depends on fresnel.glsl and
// ggx.glsl. Directions are in a frame with the normal along +z, wo above, wi on either side; `ior`
// is that of the far side against the near one, and not 1.

// The microfacet normal, above, that sends light from wi to wo.
vec3 glassNormal(vec3 wo, vec3 wi, float ior) {
  vec3 normal = wo + wi * (wi.z > 0.0 ? 1.0 : ior);
  return normalize(normal.z < 0.0 ? -normal : normal);
}

// Whether a microfacet can do that: both directions are on the side of it on which they are of the
// surface.
bool glassFacetFits(vec3 wo, vec3 wi, vec3 normal) {
  return dot(wo, normal) > 0.0 && dot(wi, normal) * wi.z > 0.0;
}

// How densely directions lie where normals have a density of one.
float glassJacobian(vec3 wo, vec3 wi, vec3 normal, float ior) {
  float out_cosine = dot(wo, normal);
  if (wi.z > 0.0) return 1.0 / (4.0 * max(out_cosine, 1.0e-7));
  float in_cosine = dot(wi, normal);
  float sum = out_cosine + ior * in_cosine;
  return ior * ior * abs(in_cosine) / max(sum * sum, 1.0e-12);
}

float glassShare(vec3 wo, vec3 wi, vec3 normal, float ior) {
  float reflected = fresnelDielectric(max(dot(wo, normal), 0.0), ior);
  return wi.z > 0.0 ? reflected : 1.0 - reflected;
}

// Times the cosine of wi. What goes through is tinted by the caller.
float evalRoughGlass(vec3 wo, vec3 wi, float alpha, float ior, float albedo) {
  vec3 normal = glassNormal(wo, wi, ior);
  if (!glassFacetFits(wo, wi, normal)) return 0.0;
  float masking = ggxMaskingShadowing(wo, vec3(wi.x, wi.y, abs(wi.z)), alpha);
  return glassShare(wo, wi, normal, ior) * masking * ggxDistribution(normal, alpha) *
         (dot(wo, normal) / (max(wo.z, 1.0e-7) * max(albedo, 0.01))) *
         glassJacobian(wo, wi, normal, ior);
}

float pdfRoughGlass(vec3 wo, vec3 wi, float alpha, float ior) {
  vec3 normal = glassNormal(wo, wi, ior);
  if (!glassFacetFits(wo, wi, normal)) return 0.0;
  return glassShare(wo, wi, normal, ior) * pdfGgxNormal(wo, normal, alpha) *
         glassJacobian(wo, wi, normal, ior);
}

// May be on the wrong side, where it stands for nothing: then it is the zero vector.
vec3 sampleRoughGlass(vec3 wo, float alpha, float ior, vec2 random, float choice) {
  vec3 normal = sampleGgxNormal(wo, alpha, random);
  float cosine = dot(wo, normal);
  if (choice < fresnelDielectric(cosine, ior)) {
    vec3 reflected = normal * (2.0 * cosine) - wo;
    return reflected.z > 0.0 ? reflected : vec3(0.0);
  }
  float refracted = refractedCosine(cosine, ior);
  vec3 through = normal * (cosine / ior - refracted) - wo * (1.0 / ior);
  return through.z < 0.0 ? through : vec3(0.0);
}
