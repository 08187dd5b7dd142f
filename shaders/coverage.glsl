// What the camera sees of a sample where the background is transparent. The sample's radiance has a
// fourth channel, which says what its ray has met: 0 nothing, SEEN_SURFACE, or SEEN_CATCHER. Of a shadow
// catcher it holds no colour but caught_light.glsl's.

vec3 seenRadiance(vec4 texel) {
  return texel.a > SEEN_CATCHER - 0.5 && isGoodSample(texel.rgb) ? vec3(0.0) : texel.rgb;
}

// Whether it has met a surface; of a shadow catcher the light that arrives there, and what would without
// shadows.
vec3 seenCoverage(vec4 texel) {
  bool surface = texel.a < SEEN_CATCHER - 0.5 && isGoodSample(texel.rgb);
  return surface ? vec3(texel.a, 0.0, 0.0) : texel.rgb;
}
