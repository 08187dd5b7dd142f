// The pass that closes a block: its samples become part of the mean.
uniform sampler2D uMean;
uniform sampler2D uBlock;

void main() {
  vec2 at = pictureAddress(pixelCenter());
  writeTexel(meanWithBlock(texture2D(uMean, at), texture2D(uBlock, at)));
}
