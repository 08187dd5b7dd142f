// Adding to the radiance of this sample: by blending, or where the device cannot blend floats by reading
// what is there.
#if !ADDITIVE_BLENDING
uniform sampler2D uRadiance;
#endif

void addToSample(vec4 sum, vec2 pixel) {
#if !ADDITIVE_BLENDING
  sum += texture2D(uRadiance, pictureAddress(pixel));
#endif
  writeTexel(sum);
}

void addRadiance(vec3 radiance, vec2 pixel) {
  addToSample(vec4(radiance, 0.0), pixel);
}
