// Unit vectors as points of a square: Cigolle et al. 2014, "A Survey of Efficient Representations
// for Independent Unit Vectors", JCGT 3(2), section 3.

// 1 for zero and above, -1 below.
float signNotZero(float x) {
  return x >= 0.0 ? 1.0 : -1.0;
}

// Unit vector to [-1, 1]^2.
vec2 encodeOctahedral(vec3 v) {
  float scale = 1.0 / (abs(v.x) + abs(v.y) + abs(v.z));
  vec2 p = vec2(v.x * scale, v.y * scale);
  vec2 folded = vec2((1.0 - abs(p.y)) * signNotZero(p.x), (1.0 - abs(p.x)) * signNotZero(p.y));
  return v.z >= 0.0 ? p : folded;
}

// [-1, 1]^2 to a unit vector.
vec3 decodeOctahedral(vec2 p) {
  float z = 1.0 - abs(p.x) - abs(p.y);
  float fold = max(-z, 0.0);
  return normalize(vec3(p.x - fold * signNotZero(p.x), p.y - fold * signNotZero(p.y), z));
}
