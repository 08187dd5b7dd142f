// The denoiser's last pass: the colour of what is seen comes back. Pixels that were to stay are those
// of the picture, to the last bit.
uniform sampler2D uMean;
uniform sampler2D uBlock;
uniform sampler2D uLight;

void main() {
  vec2 at = pictureAddress(pixelCenter());
  vec4 mean = meanWithBlock(texture2D(uMean, at), texture2D(uBlock, at));
  vec4 light = texture2D(uLight, at);
  vec3 denoised = light.rgb * demodulator(fetchGuide(at));
  writeTexel(vec4(light.a < 0.0 ? mean.rgb : denoised, mean.w));
}
