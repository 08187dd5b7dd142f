// The pass that keeps the luminance of the picture, to measure by how much it changes: in y as it is,
// in x as it was the time before.
uniform sampler2D uMean;
uniform sampler2D uBlock;
uniform sampler2D uKept;

void main() {
  vec2 at = pictureAddress(pixelCenter());
  vec4 mean = meanWithBlock(texture2D(uMean, at), texture2D(uBlock, at));
  writeTexel(vec4(texture2D(uKept, at).y, luminance(mean.rgb), 0.0, 0.0));
}
