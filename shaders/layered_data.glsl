// The BSDF of a surface in layers from the materials' texture. Dispatches on the scene's effects.

#if CLEARCOAT
// The inside of a solid that light passes has none.
Clearcoat fetchClearcoat(Surface surface, vec3 wo, bool passes) {
  vec4 coat = fetchMaterial(surface.material, 4.0);
#if TEXTURES
  coat.x *= lookUpNumbers(surface.material, CLEARCOAT_TEXTURE, surface.texcoords).r;
  coat.y *= lookUpNumbers(surface.material, CLEARCOAT_ROUGHNESS_TEXTURE, surface.texcoords).g;
#endif
  float strength = passes && surface.back > 0.5 ? 0.0 : coat.x;
  return Clearcoat(strength, coat.y, fetchGlossAlbedo(wo.z, coat.y));
}
#endif

#if SHEEN
Sheen fetchSheen(Surface surface, vec3 wo) {
  float roughness = fetchMaterial(surface.material, 4.0).z;
  vec3 color = fetchMaterial(surface.material, 5.0).rgb;
#if TEXTURES
  color *= lookUpColor(surface.material, SHEEN_COLOR_TEXTURE, surface.texcoords).rgb;
  roughness *= lookUpNumbers(surface.material, SHEEN_ROUGHNESS_TEXTURE, surface.texcoords).a;
#endif
  return Sheen(color, roughness, fetchSheenAlbedo(wo.z, roughness));
}
#endif

Bsdf fetchBsdf(Surface surface, vec3 wo) {
  Layer layer = layerOf(surface);
  Bsdf bsdf;
  bsdf.base_color = baseColorOf(surface);
  bsdf.metallic = layer.metallic;
  bsdf.roughness = layer.roughness;
  bsdf.specular = layer.specular;
  bsdf.ior = surface.back > 0.5 ? 1.0 / layer.ior : layer.ior;
  bsdf.transmission = layer.transmission;
  bsdf.gloss_albedo = vec2(0.0);
#if GLOSS || MIRROR || THIN_WALLS
  bsdf.gloss_albedo = fetchGlossAlbedo(wo.z, layer.roughness);
#endif
#if ROUGH_GLASS
  float square = fetchMaterial(surface.material, 4.0).a;
  bsdf.glass_albedo = fetchGlassAlbedo(square, wo.z, bsdf.roughness, surface.back > 0.5);
#endif
#if THIN_WALLS
  bsdf.thin = fetchMaterial(surface.material, 3.0).a;
  if (bsdf.thin > 0.5) bsdf.ior = layer.ior;
#endif
#if SHEEN
  bsdf.sheen = fetchSheen(surface, wo);
#endif
#if CLEARCOAT
  bool solid = layer.transmission > 0.0;
#if THIN_WALLS
  solid = solid && bsdf.thin < 0.5;
#endif
  bsdf.coat = fetchClearcoat(surface, wo, solid);
#endif
  return bsdf;
}
