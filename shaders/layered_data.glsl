// The BSDF of a surface in layers from the materials' texture. Dispatches on the scene's effects.

#if CLEARCOAT
// The inside of a solid that light passes has none.
Clearcoat fetchClearcoat(Surface surface, vec3 wo, bool passes) {
  vec4 coat = fetchMaterial(surface.material, 4.0);
  float strength = passes && surface.back > 0.5 ? 0.0 : coat.x;
  return Clearcoat(strength, coat.y, fetchGlossAlbedo(wo.z, coat.y));
}
#endif

#if SHEEN
Sheen fetchSheen(Surface surface, vec3 wo) {
  float roughness = fetchMaterial(surface.material, 4.0).z;
  vec3 color = fetchMaterial(surface.material, 5.0).rgb;
  return Sheen(color, roughness, fetchSheenAlbedo(wo.z, roughness));
}
#endif

Bsdf fetchBsdf(Surface surface, vec3 wo) {
  vec4 base = fetchMaterial(surface.material, 0.0);
  vec4 layer = fetchMaterial(surface.material, 2.0);
  Bsdf bsdf;
  bsdf.base_color = base.rgb;
  bsdf.metallic = base.a;
  bsdf.roughness = layer.x;
  bsdf.specular = layer.y;
  bsdf.ior = surface.back > 0.5 ? 1.0 / layer.z : layer.z;
  bsdf.transmission = layer.w;
  bsdf.gloss_albedo = vec2(0.0);
#if GLOSS || MIRROR || THIN_WALLS
  bsdf.gloss_albedo = fetchGlossAlbedo(wo.z, layer.x);
#endif
#if ROUGH_GLASS
  float square = fetchMaterial(surface.material, 4.0).a;
  bsdf.glass_albedo = fetchGlassAlbedo(square, wo.z, bsdf.roughness, surface.back > 0.5);
#endif
#if THIN_WALLS
  bsdf.thin = fetchMaterial(surface.material, 3.0).a;
  if (bsdf.thin > 0.5) bsdf.ior = layer.z;
#endif
#if SHEEN
  bsdf.sheen = fetchSheen(surface, wo);
#endif
#if CLEARCOAT
  bool solid = layer.w > 0.0;
#if THIN_WALLS
  solid = solid && bsdf.thin < 0.5;
#endif
  bsdf.coat = fetchClearcoat(surface, wo, solid);
#endif
  return bsdf;
}
