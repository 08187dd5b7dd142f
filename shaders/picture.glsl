// The picture, and every target that a path is drawn into.
uniform vec2 uPictureStep;  // (1 / width, 1 / height) in pixels

// Where the texel of a pixel is in such a target.
vec2 pictureAddress(vec2 pixel) {
  return pixel * uPictureStep;
}
