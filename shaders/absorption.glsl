// Light that is absorbed on its way through the inside of a material: Beer and Lambert's law. A ray
// is inside where it ends at the back of a surface that light passes; the materials' texture has
// zeros for all others.
vec3 transmittanceAlong(Hit hit) {
  bool inside = hit.triangle < TRIANGLE_UNKNOWN && facingOf(hit.volumes) > 0.0;
  if (!inside) return vec3(1.0);
  return exp(-fetchMaterial(hit.material, 3.0).rgb * hit.t);
}
