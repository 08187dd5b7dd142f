// What a surface's BSDF is made of, where only the material says so. The same functions as in
// textured_material.glsl.
vec3 baseColorOf(Surface surface) {
  return fetchMaterial(surface.material, 0.0).rgb;
}

Layer layerOf(Surface surface) {
  vec4 layer = fetchMaterial(surface.material, 2.0);
  return Layer(fetchMaterial(surface.material, 0.0).a, layer.x, layer.y, layer.z, layer.w);
}
