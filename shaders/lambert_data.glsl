// The BSDF of a Lambert surface from the materials' texture.
Bsdf fetchBsdf(Surface surface, vec3 wo) {
  return Bsdf(fetchMaterial(surface.material, 0.0).rgb);
}
