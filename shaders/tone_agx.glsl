// AgX (Sobotka 2022), as Blender and three.js have it: a curve over the logarithm of light, in a space
// whose primaries lie closer to grey. Bright colours go to white without changing their hue. The
// polynomial is Wrensch's fit of the curve. Depends on display_transform.glsl.

// Light at which the curve begins and ends, in stops.
const float AGX_LOW = -12.47393;
const float AGX_HIGH = 4.026069;

vec3 agxCurve(vec3 x) {
  vec3 x2 = x * x;
  vec3 x4 = x2 * x2;
  return 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x -
         0.00232;
}

// From the linear primaries of sRGB by those of Rec. 2020 to those of AgX.
vec3 agxInset(vec3 rgb) {
  vec3 wide = vec3(dot(vec3(0.6274, 0.3293, 0.0433), rgb), dot(vec3(0.0691, 0.9195, 0.0113), rgb),
                   dot(vec3(0.0164, 0.0880, 0.8956), rgb));
  return vec3(dot(vec3(0.856627153315983, 0.0951212405381588, 0.0482516061458583), wide),
              dot(vec3(0.137318972929847, 0.761241990602591, 0.101439036467562), wide),
              dot(vec3(0.11189821299995, 0.0767994186031903, 0.811302368396859), wide));
}

vec3 agxOutset(vec3 rgb) {
  return vec3(dot(vec3(1.1271005818144368, -0.11060664309660323, -0.016493938717834573), rgb),
              dot(vec3(-0.1413297634984383, 1.157823702216272, -0.016493938717834257), rgb),
              dot(vec3(-0.14132976349843826, -0.11060664309660294, 1.2519364065950405), rgb));
}

vec3 narrowToSrgb(vec3 wide) {
  return vec3(dot(vec3(1.6605, -0.5876, -0.0728), wide), dot(vec3(-0.1246, 1.1329, -0.0083), wide),
              dot(vec3(-0.0182, -0.1006, 1.1187), wide));
}

vec3 displayAgx(vec3 radiance, float scale) {
  vec3 light = max(agxInset(limitLight(radiance, scale)), vec3(1.0e-10));
  vec3 place = clamp((log2(light) - AGX_LOW) / (AGX_HIGH - AGX_LOW), 0.0, 1.0);
  vec3 shown = pow(max(agxOutset(agxCurve(place)), vec3(0.0)), vec3(2.2));
  return encodeSrgb(clamp(narrowToSrgb(shown), 0.0, 1.0));
}
