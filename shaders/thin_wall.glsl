// A wall that light passes without being bent, as KHR_materials_transmission describes it: one
// boundary, with nothing behind it. A rough one spreads what goes through as it spreads what it
// reflects. What GGX loses is added back evenly: `albedo` is what white microfacets reflect once.
// Depends on fresnel.glsl, ggx.glsl and mirror.glsl. Directions are in a frame with the normal along
// +z, wo above, wi on either side.

float thinWallShare(vec3 wo, vec3 wi, vec3 normal, float ior) {
  float reflected = fresnelDielectric(clamp(dot(wo, normal), 0.0, 1.0), ior);
  return wi.z > 0.0 ? reflected : 1.0 - reflected;
}

// What is passed is what is reflected, on the other side.
vec3 onSideOfWo(vec3 wi) {
  return vec3(wi.x, wi.y, abs(wi.z));
}

// Times the cosine of wi. What goes through is tinted by the caller.
float evalThinWall(vec3 wo, vec3 wi, float alpha, float ior, float albedo) {
  if (wi.z == 0.0) return 0.0;
  vec3 reflected = onSideOfWo(wi);
  vec3 normal = normalize(wo + reflected);
  return thinWallShare(wo, wi, normal, ior) * ggxDistribution(normal, alpha) *
         ggxMaskingShadowing(wo, reflected, alpha) / (4.0 * max(wo.z, 1.0e-7) * max(albedo, 0.01));
}

float pdfThinWall(vec3 wo, vec3 wi, float alpha, float ior) {
  if (wi.z == 0.0) return 0.0;
  vec3 normal = normalize(wo + onSideOfWo(wi));
  return thinWallShare(wo, wi, normal, ior) * pdfGgxReflection(wo, normal, alpha);
}

// The zero vector, which stands for nothing, where a microfacet reflects into the surface.
vec3 sampleThinWall(vec3 wo, float alpha, float ior, vec2 random, float choice) {
  vec3 normal = sampleGgxNormal(wo, alpha, random);
  float cosine = dot(wo, normal);
  vec3 wi = normal * (2.0 * cosine) - wo;
  if (!(wi.z > 0.0)) return vec3(0.0);
  bool reflects = choice < fresnelDielectric(clamp(cosine, 0.0, 1.0), ior);
  return reflects ? wi : vec3(wi.x, wi.y, -wi.z);
}

// Of a smooth wall.
vec3 sampleThinPane(vec3 wo, float ior, float random) {
  return random < fresnelDielectric(wo.z, ior) ? mirrorDirection(wo) : -wo;
}
