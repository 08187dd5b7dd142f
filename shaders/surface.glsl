// The surface that a hit record speaks of. Dispatches on the scene's effects.

struct Surface {
  vec3 position;   // where rays leave from, and light arrives
  vec3 geometric;  // unit normal of the triangle, on the side where the path arrived
  vec3 normal;     // the same for shading
  float error_scale;
  float material;
  float back;      // 1 where the path arrived at the triangle's back side, else 0
  float rise;      // of the position above the triangle; see shadow_terminator.glsl
#if TEXTURES
  vec4 texcoords;  // see attribute_data.glsl
#endif
#if VERTEX_COLORS
  vec4 color;
#endif
};

// Where the path came from, in the frame of the shading normal: always above, also where that normal
// is turned away.
vec3 outgoing(Frame frame, vec3 arrived) {
  vec3 wo = toFrame(frame, -arrived);
  return wo.z >= 1.0e-4 ? wo : normalize(vec3(wo.xy, 1.0e-4));
}

// Where a ray starts that goes through the triangle.
vec3 passSurface(Surface surface) {
  return leaveSurface(surface.position - surface.geometric * surface.rise, -surface.geometric,
                      surface.error_scale);
}

Surface surfaceOf(HitRecord record) {
  TriangleData data = fetchTriangle(record.triangle);
  vec3 normal = normalize(cross(data.v1 - data.v0, data.v2 - data.v0));
  float side = 1.0 - 2.0 * record.back;
  float error_scale = errorScale(data.v0, data.v1, data.v2);
  vec2 uv = awayFromEdges(data.v0, data.v1, data.v2, record.uv, error_scale);
  vec3 position = interpolate(data.v0, data.v1, data.v2, uv);
  vec3 shading = normal;
  float rise = 0.0;
#if SMOOTH_NORMALS
  VertexNormals normals = fetchNormals(record.triangle, normal);
  shading = interpolatedNormal(normals, record.uv, normal);
  vec3 geometric = side * normal;
  vec3 rises = vec3(riseToTangent(position, data.v0, side * normals.n0, geometric),
                    riseToTangent(position, data.v1, side * normals.n1, geometric),
                    riseToTangent(position, data.v2, side * normals.n2, geometric));
  rise = dot(rises, vec3(1.0 - uv.x - uv.y, uv));
  position += geometric * rise;
#endif
  shading *= side;
#if TEXTURES
  VertexTexcoords vertices = fetchTexcoords(record.triangle);
  vec4 texcoords = interpolatedTexcoords(vertices, record.uv);
#endif
#if NORMAL_MAPS
  shading = side * mappedNormal(data, vertices, texcoords, side * shading);
  shading = turnedToViewer(shading, record.direction);
#endif
  return Surface(position, side * normal, shading, error_scale, data.material, record.back, rise
#if TEXTURES
                 , texcoords
#endif
#if VERTEX_COLORS
                 , interpolatedColor(record.triangle, record.uv)
#endif
                 );
}
