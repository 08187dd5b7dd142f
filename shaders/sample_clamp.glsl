// Samples brighter than was asked for are dimmed to that, in their own colour: fewer specks, and less
// light.
uniform float uClamp;  // luminance, above 0

vec3 clampedSample(vec3 radiance) {
  return radiance * (uClamp / max(luminance(radiance), uClamp));
}
