// The surface that a hit record speaks of. Dispatches on the scene's effects.

struct Surface {
  vec3 position;
  vec3 geometric;  // unit normal of the triangle, on the side where the path arrived
  vec3 normal;     // the same for shading
  float error_scale;
  float material;
  float back;      // 1 where the path arrived at the triangle's back side, else 0
};

// Where the path came from, in the frame of the shading normal: always above, also where that normal
// is turned away.
vec3 outgoing(Frame frame, vec3 arrived) {
  vec3 wo = toFrame(frame, -arrived);
  return wo.z >= 1.0e-4 ? wo : normalize(vec3(wo.xy, 1.0e-4));
}

Surface surfaceOf(HitRecord record) {
  TriangleData data = fetchTriangle(record.triangle);
  vec3 normal = normalize(cross(data.v1 - data.v0, data.v2 - data.v0));
  float side = 1.0 - 2.0 * record.back;
  vec3 shading = normal;
#if SMOOTH_NORMALS
  shading = fetchNormal(record.triangle, record.uv, normal);
#endif
  return Surface(interpolate(data.v0, data.v1, data.v2, record.uv), side * normal, side * shading,
                 errorScale(data.v0, data.v1, data.v2), data.material, record.back);
}
