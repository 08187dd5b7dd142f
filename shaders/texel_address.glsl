// Where element i of a texture of power-of-two sizes is, for textures that repeat. The row needs no
// rounding: x counts rows in its whole part, and half a texel's fraction keeps it off the borders.
// `texel_step` is (1 / width, 1 / (width * height)), so that element i + n is n steps further.
vec2 texelAddress(float i, vec2 texel_step) {
  return (i + 0.5) * texel_step;
}
