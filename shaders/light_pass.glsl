// The light pass: hit record to radiance.
uniform sampler2D uRecord;
uniform float uLastSurface;  // see light.glsl

void main() {
  vec2 pixel = pixelCenter();
  vec4 texel = texture2D(uRecord, pictureAddress(pixel));
  addRadiance(radianceOf(decodeHitRecord(texel), isEnded(texel), samplePoint(pixel), uLastSurface),
              pixel);
}
