// The pass that adds what one path has come to to the sum over paths.
uniform sampler2D uGuide;
uniform sampler2D uGuideSum;

void main() {
  vec2 at = pictureAddress(pixelCenter());
  writeTexel(texture2D(uGuideSum, at) + texture2D(uGuide, at));
}
