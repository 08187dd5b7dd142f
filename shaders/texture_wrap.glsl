// What is beyond the edges of a picture, in whole texels. A wrap is 0: the picture is repeated, 1:
// every other repetition is mirrored, 2: its edges go on.

// The texel of a row of `size` that stands for texel `i`, which may be anywhere.
float wrapTexel(float i, float size, float wrap) {
  // Half a texel keeps the quotient off whole numbers, which division would not always meet.
  float period = wrap == 1.0 ? 2.0 * size : size;
  float repeated = i - period * floor((i + 0.5) / period);
  float mirrored = repeated < size ? repeated : period - 1.0 - repeated;
  float wrapped = wrap == 2.0 ? i : mirrored;
  return clamp(wrapped, 0.0, size - 1.0);
}
