// Where element i of a texture of power-of-two sizes is, for textures that repeat. The row needs no
// rounding: x counts rows in its whole part, and half a texel's fraction keeps it off the borders.
// `size` is the width and the height in texels.
vec2 texelAddress(float i, vec2 size) {
  float rows = (i + 0.5) / size.x;
  return vec2(rows, rows / size.y);
}
