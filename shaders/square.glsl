// What the spread of a pixel's samples is known by: the square of their luminance.
vec3 luminanceSquare(vec4 texel) {
  vec3 radiance = seenRadiance(texel);
  float light = luminance(radiance);
  return isGoodSample(radiance) ? vec3(light * light, 0.0, 0.0) : radiance;
}
