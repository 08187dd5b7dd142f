// Hill's fit of ACES, reference rendering and output transform for sRGB displays (BakingLab, 2016):
// contrast as of film. Light is brightened as in three.js, so that middle grey is about as bright as
// without it. Depends on display_transform.glsl.

vec3 acesInput(vec3 rgb) {
  return vec3(dot(vec3(0.59719, 0.35458, 0.04823), rgb), dot(vec3(0.07600, 0.90834, 0.01566), rgb),
              dot(vec3(0.02840, 0.13383, 0.83777), rgb));
}

vec3 acesOutput(vec3 rgb) {
  return vec3(dot(vec3(1.60475, -0.53108, -0.07367), rgb),
              dot(vec3(-0.10208, 1.10813, -0.00605), rgb),
              dot(vec3(-0.00327, -0.07276, 1.07602), rgb));
}

vec3 acesCurve(vec3 x) {
  return (x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.4329510) + 0.238081);
}

vec3 displayAces(vec3 radiance, float scale) {
  vec3 light = acesInput(limitLight(radiance, scale) / 0.6);
  return encodeSrgb(clamp(acesOutput(acesCurve(light)), 0.0, 1.0));
}
