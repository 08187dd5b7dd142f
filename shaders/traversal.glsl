// What every traversal shares. A traversal is a file traverse_*.glsl that defines
//
//   struct Walk { ...; float link; };
//   Walk startWalk(vec3 origin, vec3 direction, bool wanted);
//   void walkToLeaf(inout Walk walk, float t);
//
// walkToLeaf goes on to the next leaf whose box the ray meets before t. It leaves in `link` what it
// found: -1 - index of the leaf's first triangle, or 0 at the end, or anything positive where the
// driver cut the walk short. A ray that is not wanted is at the end from the start.

// The slab test loses some bits: distances to the far side are made longer by several roundings (Ize
// 2013, "Robust BVH Ray Traversal").
#define BOX_SLACK 1.000001

struct Hit {
  float triangle;  // index, or TRIANGLE_NONE, or TRIANGLE_UNKNOWN where the traversal was cut short
  float t;         // see orderOf
  vec3 volumes;    // see triangle.glsl
  float material;  // index
  float area;      // square metres
};

// Whether a triangle that intersectTriangle found at `t` is in the ray's way. One that the camera
// stands on is not. A ray that leaves a surface may be rounded onto another one, and does not get past.
bool isInTheWay(float t) {
#if FROM_CAMERA && !FROM_RECORD
  return t > 0.0;
#else
  return t >= 0.0;
#endif
}

// The sign of facingOf() where the ray meets the side that it has left; 0 where it has left none.
float side_left = 0.0;

// What a distance is multiplied with to tell what the ray meets first. Beside an edge behind which the
// surface turns away, a ray meets both faces, and rounding may take the second one for the first: a
// path inside a closed mesh would go on outside. There, what shows the side that the ray has left is
// first.
float orderOf(vec3 volumes) {
  return facingOf(volumes) * side_left < 0.0 ? 1.00001 : 1.0;
}

// Directions along an axis would multiply zero by infinity.
vec3 inverseOf(vec3 direction) {
  vec3 side = vec3(direction.x < 0.0 ? -1.0 : 1.0, direction.y < 0.0 ? -1.0 : 1.0,
                   direction.z < 0.0 ? -1.0 : 1.0);
  return side / max(abs(direction), vec3(1.0e-18));
}
