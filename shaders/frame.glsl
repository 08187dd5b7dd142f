// Orthonormal bases.

struct Frame {
  vec3 tangent;
  vec3 bitangent;
  vec3 normal;
};

// Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1). `normal` is unit.
Frame frameAround(vec3 normal) {
  float side = normal.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (side + normal.z);
  float b = normal.x * normal.y * a;
  return Frame(vec3(1.0 + side * normal.x * normal.x * a, side * b, -side * normal.x),
               vec3(b, side + normal.y * normal.y * a, -normal.y),
               normal);
}

vec3 toFrame(Frame frame, vec3 v) {
  return vec3(dot(v, frame.tangent), dot(v, frame.bitangent), dot(v, frame.normal));
}

vec3 fromFrame(Frame frame, vec3 local) {
  return local.x * frame.tangent + local.y * frame.bitangent + local.z * frame.normal;
}
