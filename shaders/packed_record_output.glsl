// Writing the record of a pixel, packed into one texel.

// A path that does not go on has ended. `random` is for rounding; see encodeHitRecord.
void writeRecord(HitRecord record, bool goes_on, vec4 random) {
  vec4 texel = encodeHitRecord(record, random);
  writeTexel(goes_on ? texel : vec4(0.0));
}
