// ES 3.0: writing the record of a pixel into three targets; see wide_record_input.glsl.
layout(location = 1) out highp vec4 recordDirection;
layout(location = 2) out highp vec4 recordThroughput;

// A path that does not go on has ended, and so has one that packing would end. Nothing is rounded:
// `random` is for the record that is packed.
void writeRecord(HitRecord record, bool goes_on, vec4 random) {
  vec3 throughput = record.throughput;
  float largest = max(throughput.r, max(throughput.g, throughput.b));
  float live = goes_on && largest >= LEAST_THROUGHPUT ? 1.0 : 0.0;
  writeTexel(vec4(live, record.triangle, record.uv));
  recordDirection = vec4(record.direction, record.back) + uZero;
  recordThroughput = vec4(throughput, record.weight) + uZero;
}
