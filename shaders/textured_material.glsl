// What a surface's BSDF is made of, where pictures and vertex colours vary the material. Dispatches on
// the scene's effects. The same functions as in plain_material.glsl.
vec3 baseColorOf(Surface surface) {
  vec3 color = fetchMaterial(surface.material, 0.0).rgb;
#if TEXTURES
  color *= lookUpColor(surface.material, BASE_COLOR_TEXTURE, surface.texcoords).rgb;
#endif
#if VERTEX_COLORS
  color *= surface.color.rgb;
#endif
  return color;
}

Layer layerOf(Surface surface) {
  vec4 layer = fetchMaterial(surface.material, 2.0);
  float metallic = fetchMaterial(surface.material, 0.0).a;
#if TEXTURES
  vec4 shares = lookUpNumbers(surface.material, METALLIC_ROUGHNESS_TEXTURE, surface.texcoords);
  metallic *= shares.b;
  layer.x *= shares.g;
#if GLASS || ROUGH_GLASS
  layer.w *= lookUpNumbers(surface.material, TRANSMISSION_TEXTURE, surface.texcoords).r;
#endif
#endif
  return Layer(metallic, layer.x, layer.y, layer.z, layer.w);
}
