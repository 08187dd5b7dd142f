// Ray against triangle.

struct TriangleHit {
  float t;       // along the direction, in its lengths; negative where the triangle is missed
  vec3 volumes;  // of the ray with the edges, in proportion to the weights of vertices 1, 2 and 0
};

// One edge function of the ray from the origin: twelve times the volume it spans with the edge. Only
// the sum and the difference of the ends are used, so that the triangle on the other side of the
// edge gets the same number with the other sign, to the last bit, and no ray passes between the
// two. Also holds where the compiler fuses multiplications and additions.
float edgeVolume(vec3 from, vec3 to, vec3 direction) {
  return dot(cross(to - from, to + from), direction);
}

// The edge functions of Plücker coordinates, in the form of Davidovič, Engelhardt, Georgiev,
// Slusallek and Dachsbacher 2012, "3D Rasterization: A Bridge between Rasterization and Ray
// Casting". Hits both sides. Distances in [0, far).
TriangleHit intersectTriangle(vec3 origin, vec3 direction, vec3 v0, vec3 v1, vec3 v2, float far) {
  vec3 a = v0 - origin;
  vec3 b = v1 - origin;
  vec3 c = v2 - origin;
  float u = edgeVolume(a, c, direction);
  float v = edgeVolume(b, a, direction);
  float w = edgeVolume(c, b, direction);
  vec3 normal = cross(b - a, c - a);
  float t = dot(a, normal) / dot(direction, normal);
  bool inside = min(u, min(v, w)) >= 0.0 || max(u, max(v, w)) <= 0.0;
  bool hit = inside && t >= 0.0 && t < far;
  return TriangleHit(hit ? t : -1.0, vec3(u, v, w));
}

// Twice the dot product of the direction and the triangle's normal, whose length is its double area:
// negative where the ray comes from the front.
float facingOf(vec3 volumes) {
  return volumes.x + volumes.y + volumes.z;
}

// Barycentric weights of vertices 1 and 2. Where a sliver is so thin that no volume is left, vertex
// 0's is one.
vec2 weightsOf(vec3 volumes) {
  float sum = facingOf(volumes);
  return vec2(volumes.x, volumes.y) / (sum == 0.0 ? 1.0 : sum);
}

vec3 interpolate(vec3 at0, vec3 at1, vec3 at2, vec2 uv) {
  return (1.0 - uv.x - uv.y) * at0 + uv.x * at1 + uv.y * at2;
}
