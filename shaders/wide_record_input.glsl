// ES 3.0: reading the record of a pixel, where it is kept in three texels, every field a float of its
// own. What the packed record is measured against.
//
//   uRecord            1 for a path that goes on, 0 for one that has ended; triangle; u; v
//   uRecordDirection   direction x, y, z; back side
//   uRecordThroughput  throughput r, g, b; weight of the emission
uniform sampler2D uRecord;
uniform sampler2D uRecordDirection;
uniform sampler2D uRecordThroughput;

// False where the path has ended: then there is no record.
bool readRecord(vec2 pixel, out HitRecord record) {
  vec2 at = pictureAddress(pixel);
  vec4 place = texture2D(uRecord, at);
  vec4 direction = texture2D(uRecordDirection, at);
  vec4 throughput = texture2D(uRecordThroughput, at);
  record = HitRecord(place.y, direction.w, place.zw, direction.xyz, throughput.xyz, throughput.w);
  return place.x > 0.5;
}
