// The trace pass: one ray of every path. The camera pass is the same without a record to start from.
void main() {
  vec2 pixel = pixelCenter();
  vec4 random = samplePoint(pixel);
#if FROM_CAMERA
  PathRay ray = cameraRay(pixel, random);
#else
  HitRecord start;
  bool live = readRecord(pixel, start);
  PathRay ray = scatteredRay(start, !live, random);
#endif
  Hit hit = closestHit(ray.origin, ray.direction, ray.wanted);

#if FROM_CAMERA
  float weight = 1.0;
#else
  float weight = emissionWeight(ray, hit);
#endif
  vec4 rounding = vec4(random.z, random.w, lowBits(random.z), lowBits(random.w));
  writeRecord(recordOf(ray, hit, weight), goesOn(ray, hit), rounding);
}
