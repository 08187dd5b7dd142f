// Ray against triangle.

struct TriangleHit {
  float t;  // along the direction, in its lengths; negative where the triangle is missed
  float u;  // weight of vertex 1
  float v;  // weight of vertex 2
};

// One edge function of the ray from the origin: six times the volume it spans with the edge. Only
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
  float sum = u + v + w;
  vec3 normal = cross(b - a, c - a);
  float t = dot(a, normal) / dot(direction, normal);
  bool inside = min(u, min(v, w)) >= 0.0 || max(u, max(v, w)) <= 0.0;
  bool hit = inside && sum != 0.0 && t >= 0.0 && t < far;
  return TriangleHit(hit ? t : -1.0, u / sum, v / sum);
}

vec3 interpolate(vec3 at0, vec3 at1, vec3 at2, vec2 uv) {
  return (1.0 - uv.x - uv.y) * at0 + uv.x * at1 + uv.y * at2;
}
