// The light pass: hit record to radiance.
uniform sampler2D uRecord;
uniform float uLastSurface;  // 1 or 0

#if !ADDITIVE_BLENDING
uniform sampler2D uRadiance;
#endif

void main() {
  vec2 pixel = pixelCenter();
  vec4 texel = texture2D(uRecord, pictureAddress(pixel));
  vec4 radiance = vec4(radianceOf(decodeHitRecord(texel), isEnded(texel), samplePoint(pixel),
                                  uLastSurface), 0.0);
#if !ADDITIVE_BLENDING
  radiance += texture2D(uRadiance, pictureAddress(pixel));
#endif
  writeTexel(radiance);
}
