// The display pass: the picture as a display shows it. The composer defines DISPLAY_TRANSFORM, the
// function of the tone that was asked for.
uniform sampler2D uMean;
uniform sampler2D uBlock;
uniform vec2 uDisplaySize;
uniform float uExposureScale;

void main() {
  vec2 at = pixelCenter() / uDisplaySize;
  vec3 radiance = meanWithBlock(texture2D(uMean, at), texture2D(uBlock, at)).rgb;
  writeTexel(vec4(DISPLAY_TRANSFORM(radiance, uExposureScale), 1.0));
}
