// Reading the record of a pixel, where it is packed into one texel.
uniform sampler2D uRecord;

// False where the path has ended: then there is no record.
bool readRecord(vec2 pixel, out HitRecord record) {
  vec4 texel = texture2D(uRecord, pictureAddress(pixel));
  record = decodeHitRecord(texel);
  return !isEnded(texel);
}
