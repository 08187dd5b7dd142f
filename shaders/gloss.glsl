// Reflection by a rough surface: GGX microfacets with Schlick's Fresnel, and what is reflected more
// than once among them added back: Turquin 2019, "Practical multiple scattering compensation for
// microfacet models", equation 16. Depends on fresnel.glsl and ggx.glsl. Directions are in a frame
// with the normal along +z, wo and wi above.

// What of the light a rough surface reflects into all directions, once: of a white one without
// Fresnel `x` + `y`, the part of it that goes with the reflectance at normal incidence in x, that
// which goes with the one at the horizon in y. `albedo` is of the table in gloss_albedo.glsl.
vec3 glossAlbedo(vec3 normal_incidence, float grazing, vec2 albedo) {
  vec3 once = normal_incidence * albedo.x + vec3(grazing * albedo.y);
  return once * (vec3(1.0) + normal_incidence * (1.0 / max(albedo.x + albedo.y, 0.01) - 1.0));
}

// Times the cosine of wi.
vec3 evalGloss(vec3 wo, vec3 wi, float alpha, vec3 normal_incidence, float grazing, vec2 albedo) {
  if (!(wi.z > 0.0)) return vec3(0.0);
  vec3 normal = normalize(wo + wi);
  vec3 fresnel = fresnelSchlick(normal_incidence, grazing, dot(wo, normal));
  vec3 multiple = vec3(1.0) + normal_incidence * (1.0 / max(albedo.x + albedo.y, 0.01) - 1.0);
  return fresnel * multiple *
         (ggxDistribution(normal, alpha) * ggxMaskingShadowing(wo, wi, alpha) /
          (4.0 * max(wo.z, 1.0e-7)));
}

float pdfGloss(vec3 wo, vec3 wi, float alpha) {
  if (!(wi.z > 0.0)) return 0.0;
  return pdfGgxReflection(wo, normalize(wo + wi), alpha);
}

// The zero vector, which stands for nothing, where a microfacet reflects into the surface: other lobes
// may have light from there.
vec3 sampleGloss(vec3 wo, float alpha, vec2 random) {
  vec3 normal = sampleGgxNormal(wo, alpha, random);
  vec3 wi = normal * (2.0 * dot(wo, normal)) - wo;
  return wi.z > 0.0 ? wi : vec3(0.0);
}
