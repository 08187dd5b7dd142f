// The surface that a hit record speaks of. Dispatches on the scene's effects.

struct Surface {
  vec3 position;   // where rays leave from, and light arrives
  vec3 geometric;  // unit normal of the triangle, on the side where the path arrived
  vec3 normal;     // the same for shading
  float error_scale;
  float material;
};

Surface surfaceOf(HitRecord record) {
  TriangleData data = fetchTriangle(record.triangle);
  vec3 normal = normalize(cross(data.v1 - data.v0, data.v2 - data.v0));
  float side = 1.0 - 2.0 * record.back;
  vec3 position = interpolate(data.v0, data.v1, data.v2, record.uv);
  vec3 shading = normal;
#if SMOOTH_NORMALS
  VertexNormals normals = fetchNormals(record.triangle, normal);
  shading = interpolatedNormal(normals, record.uv, normal);
  vec3 geometric = side * normal;
  vec3 rises = vec3(riseToTangent(position, data.v0, side * normals.n0, geometric),
                    riseToTangent(position, data.v1, side * normals.n1, geometric),
                    riseToTangent(position, data.v2, side * normals.n2, geometric));
  position += geometric * dot(rises, vec3(1.0 - record.uv.x - record.uv.y, record.uv));
#endif
  return Surface(position, side * normal, side * shading, errorScale(data.v0, data.v1, data.v2),
                 data.material);
}
