// The triangles' texture, laid out as layout.h says.
uniform sampler2D uTriangles;
uniform vec2 uTrianglesStep;

struct TriangleData {
  vec3 v0;
  vec3 v1;
  vec3 v2;
  float material;  // index
  float area;      // square metres
  bool last;       // of its leaf
  float passable;  // 1 if light may pass it, see alpha.glsl
};

TriangleData fetchTriangle(float index) {
  vec2 at = texelAddress(index * TRIANGLE_TEXELS, uTrianglesStep);
  vec4 t0 = texture2D(uTriangles, at);
  vec4 t1 = texture2D(uTriangles, at + uTrianglesStep);
  vec4 t2 = texture2D(uTriangles, at + 2.0 * uTrianglesStep);
  return TriangleData(t0.xyz, t1.xyz, t2.xyz, abs(t0.w) - 1.0, t1.w, t0.w < 0.0,
                      t2.w);
}
