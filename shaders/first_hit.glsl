// The pass that tells what the camera's ray has met: by uWanted
//   0: the base colour
//   1: the unit shading normal, on the camera's side
//   2: the position; 1 + material index
// The fourth channel is 0 where it has met nothing.
uniform float uWanted;

void main() {
  vec2 pixel = pixelCenter();
  HitRecord record;
  bool hit = readRecord(pixel, record) && record.triangle < TRIANGLE_UNKNOWN;
  if (!hit) record = HitRecord(0.0, 0.0, vec2(0.25), vec3(0.0, 0.0, -1.0), vec3(1.0), 1.0);
  Surface surface = surfaceOf(record);
  vec4 value = vec4(baseColorOf(surface), 1.0);
  if (uWanted > 0.5) value = vec4(surface.normal, 1.0);
  if (uWanted > 1.5) value = vec4(surface.position, 1.0 + surface.material);
  writeTexel(hit ? value : vec4(0.0));
}
