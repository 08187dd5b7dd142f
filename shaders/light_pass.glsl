// The light pass: hit record to radiance.
uniform sampler2D uRecord;
uniform float uLastSurface;  // 1 or 0

void main() {
  vec2 pixel = pixelCenter();
  vec4 texel = texture2D(uRecord, pictureAddress(pixel));
  addRadiance(radianceOf(decodeHitRecord(texel), isEnded(texel), samplePoint(pixel), uLastSurface),
              pixel);
}
