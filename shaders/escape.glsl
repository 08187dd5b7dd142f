// The light that a path brings which has left the scene.
vec3 escapedRadiance(HitRecord record) {
  return record.throughput * (environmentRadiance(record.direction) * record.weight);
}
