// The BSDF of a surface in layers from its material. Dispatches on the scene's effects.
Bsdf fetchBsdf(Surface surface, vec3 wo) {
  Layer layer = layerOf(surface);
  float ior = surface.back > 0.5 ? 1.0 / layer.ior : layer.ior;
  vec2 albedo = vec2(0.0);
#if GLOSS || MIRROR
  albedo = fetchGlossAlbedo(wo.z, layer.roughness);
#endif
  return Bsdf(baseColorOf(surface), layer.metallic, layer.roughness, layer.specular, ior,
              layer.transmission, albedo);
}
