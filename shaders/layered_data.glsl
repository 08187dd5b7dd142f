// The BSDF of a surface in layers from the materials' texture. Dispatches on the scene's effects.
Bsdf fetchBsdf(Surface surface, vec3 wo) {
  vec4 base = fetchMaterial(surface.material, 0.0);
  vec4 layer = fetchMaterial(surface.material, 2.0);
  float ior = surface.back > 0.5 ? 1.0 / layer.z : layer.z;
  vec2 albedo = vec2(0.0);
#if GLOSS || MIRROR
  albedo = fetchGlossAlbedo(wo.z, layer.x);
#endif
  return Bsdf(base.rgb, base.a, layer.x, layer.y, ior, layer.w, albedo);
}
