// The perfect mirror, of a surface without roughness.
vec3 mirrorDirection(vec3 wo) {
  return vec3(-wo.x, -wo.y, wo.z);
}
