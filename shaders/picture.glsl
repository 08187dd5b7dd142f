// The picture, and every target that a path is drawn into.
uniform vec2 uPictureSize;  // pixels
