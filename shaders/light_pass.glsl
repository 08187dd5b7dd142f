// The light pass: hit record to radiance.
uniform float uLastSurface;  // see light.glsl

void main() {
  vec2 pixel = pixelCenter();
  HitRecord record;
  bool live = readRecord(pixel, record);
  addRadiance(radianceOf(record, !live, samplePoint(pixel), uLastSurface), pixel);
}
