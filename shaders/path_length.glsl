// How many surfaces a sample's path has met: where it is asked for, the light pass counts them in the
// fourth channel.
vec3 pathLength(vec4 texel) {
  return isGoodSample(texel.rgb) ? vec3(texel.a, 0.0, 0.0) : texel.rgb;
}
