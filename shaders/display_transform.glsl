// From linear radiance to what a display is sent: exposed, clipped at one, sRGB-encoded (IEC
// 61966-2-1).
vec3 encodeSrgb(vec3 linear) {
  vec3 low = 12.92 * linear;
  vec3 high = 1.055 * pow(max(linear, vec3(1.0e-6)), vec3(1.0 / 2.4)) - 0.055;
  return mix(high, low, step(linear, vec3(0.0031308)));
}

// Exposed light as curves take it: none of it negative, and so little that its square is finite.
// `scale` is 2 to the exposure in EV.
vec3 limitLight(vec3 radiance, float scale) {
  return clamp(radiance * scale, 0.0, 65504.0);
}

vec3 displayTransform(vec3 radiance, float scale) {
  return encodeSrgb(clamp(radiance * scale, 0.0, 1.0));
}
