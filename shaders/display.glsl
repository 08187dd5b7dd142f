// The display pass: the picture as a display shows it.
uniform sampler2D uMean;
uniform vec2 uDisplaySize;
uniform float uExposureScale;

void main() {
  vec3 radiance = texture2D(uMean, pixelCenter() / uDisplaySize).rgb;
  writeTexel(vec4(displayTransform(radiance, uExposureScale), 1.0));
}
