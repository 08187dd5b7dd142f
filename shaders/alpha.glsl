// Surfaces with holes, and surfaces that let a share of the light pass. A path meets such a surface as
// often as light does not pass it; a shadow ray is weakened by the share that passes. Dispatches on
// the scene's effects.

// Decides what the path meets: uniform in [0, 1), and after every decision again, whatever it was.
float alpha_random;

// The share of light that a triangle stops. `uv` are weights of vertices 1 and 2.
float opacityAt(float triangle, float material, vec2 uv) {
  vec4 factors = fetchMaterial(material, TEXTURE_FACTORS);
  float alpha = factors.x;
#if TEXTURES
  vec4 texcoords = interpolatedTexcoords(fetchTexcoords(triangle), uv);
  alpha *= lookUpNumbers(material, BASE_COLOR_TEXTURE, texcoords).a;
#endif
#if VERTEX_COLORS
  alpha *= interpolatedColor(triangle, uv).a;
#endif
  float without_holes = alpha >= factors.y ? 1.0 : 0.0;
  return factors.y < 0.0 ? clamp(alpha, 0.0, 1.0) : without_holes;
}

// The same where the ray has hit the triangle. The loop is a branch, as in texture_data.glsl.
float opacityOfHit(TriangleData data, float index, TriangleHit met, bool is_hit) {
  float opacity = is_hit ? 1.0 : 0.0;
  bool wanted = is_hit && data.passable > 0.5;
  for (int i = 0; i < MAX_STEPS; i++) {
    if (!wanted) break;
    opacity = opacityAt(index, data.material, weightsOf(met.volumes));
    wanted = false;
  }
  return opacity;
}

bool stopsPath(TriangleData data, float index, TriangleHit met, bool is_hit) {
  float opacity = opacityOfHit(data, index, met, is_hit);
  if (opacity <= 0.0) return false;
  if (opacity >= 1.0) return true;
  bool stops = alpha_random < opacity;
  float left = stops ? alpha_random / opacity : (alpha_random - opacity) / (1.0 - opacity);
  // Each decision uses up some of the number's bits. A shift by what differs from ray to ray replaces
  // them, and leaves it uniform.
  alpha_random = fract(left + fract(met.t * 4096.0));
  return stops;
}

float shareThatPasses(TriangleData data, float index, TriangleHit met, bool is_hit) {
  return 1.0 - opacityOfHit(data, index, met, is_hit);
}
