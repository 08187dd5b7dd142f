// The pass that tells the denoiser what a path has come to, whose pixels without a path keep what the
// target holds: by uWanted
//   0: by what the light of neighbours is comparable: base colour and emission, times the
//   throughput; 1 where the path has met a surface, 0 where it sees the environment
//   1: unit shading normal; metres along the view, 0 behind mirrors and glass
// What is seen in mirrors and through glass is a mixture, by chance, of surfaces far from each other: of
// what bears no comparison less is told.
uniform float uWanted;
uniform vec3 uCameraPosition;
uniform vec3 uCameraForward;

void main() {
  vec2 pixel = pixelCenter();
  HitRecord record;
  bool live = readRecord(pixel, record) && record.triangle != TRIANGLE_UNKNOWN;
  if (!live) discard;
  bool hit = record.triangle < TRIANGLE_UNKNOWN;
  bool direct = isSeen();
  vec3 environment = vec3(1.0);
#if TRANSPARENT_BACKGROUND
  if (direct) environment = vec3(0.0);
#endif
#if SHADOW_CATCHER
  hit = hit && !isShadowCatcher(record);
#endif
  Surface surface = surfaceOf(record);
  vec3 emitted = emittedRadiance(record, surface);
  vec3 color = baseColorOf(surface) + (direct ? emitted : min(emitted, vec3(1.0)));
  vec4 look = vec4(record.throughput * (hit ? color : environment), hit ? 1.0 : 0.0);
  float depth = dot(surface.position - uCameraPosition, uCameraForward);
  vec4 place = vec4(surface.normal, direct ? depth : 0.0);
  writeTexel(uWanted < 0.5 ? look : (hit ? place : vec4(0.0)));
}
