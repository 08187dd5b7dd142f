// The BSDF of a Lambert surface from its material.
Bsdf fetchBsdf(Surface surface, vec3 wo) {
  return Bsdf(baseColorOf(surface));
}
