// The light pass: hit record to radiance.
uniform float uLastSurface;  // 1 or 0

void main() {
  vec2 pixel = pixelCenter();
  HitRecord record;
  bool live = readRecord(pixel, record);
  addRadiance(radianceOf(record, !live, samplePoint(pixel), uLastSurface), pixel);
}
