// Skip links, one tree order per ray octant: no stack, no restart, no bit operations.
//
// The tree is stored eight times, once for each combination of the direction's signs, depth first
// and with the child that the ray meets first in front. A box that is met leads to the next node, a
// box that is missed to the node behind its subtree. Since the order knows the signs, so do the
// boxes: they are stored as the corner where the ray enters and the corner where it leaves. Each
// copy ends with a node that counts as a leaf whether it is met or not, so that walking needs one
// test.
//
// A fetch costs more than the arithmetic to unpack it, so a node is one texel: its box is rounded
// outwards to a grid, twelve bits a coordinate. The ray is moved to the grid once.
uniform sampler2D uNodes;
uniform vec2 uNodesStep;
uniform float uNodesPerOctant;  // with the one at the end
uniform vec3 uGridOrigin;
uniform vec3 uGridCell;         // metres

// More steps than any sound tree asks for. A driver may stop earlier.
#define MAX_STEPS 65536

// The slab test loses some bits: distances to the far side are made longer by several roundings (Ize
// 2013, "Robust BVH Ray Traversal").
#define BOX_SLACK 1.000001

struct Hit {
  float triangle;  // index, or TRIANGLE_NONE, or TRIANGLE_UNKNOWN where the traversal was cut short
  float t;
  vec3 volumes;    // see triangle.glsl
  float material;  // index
  float area;      // square metres
};

struct Walk {
  vec3 origin;      // on the grid
  vec3 inverse;     // 1 / direction, likewise
  vec2 texel_step;  // a uniform that is read inside a loop is read again at each turn
  float node;       // the next to visit
  float link;       // of the last visited: negative at a leaf, 0 at the end; see layout.h
};

// Directions along an axis would multiply zero by infinity.
vec3 inverseOf(vec3 direction) {
  vec3 side = vec3(direction.x < 0.0 ? -1.0 : 1.0, direction.y < 0.0 ? -1.0 : 1.0,
                   direction.z < 0.0 ? -1.0 : 1.0);
  return side / max(abs(direction), vec3(1.0e-18));
}

// A ray that is not wanted starts at the end.
Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  vec3 negative = 1.0 - step(vec3(0.0), direction);
  float octant = dot(negative, vec3(1.0, 2.0, 4.0));
  float node = octant * uNodesPerOctant + (wanted ? 0.0 : uNodesPerOctant - 1.0);
  return Walk((origin - uGridOrigin) / uGridCell, inverseOf(direction) * uGridCell,
              uNodesStep, node, 1.0);
}

// To the next leaf whose box the ray meets before t.
void walkToLeaf(inout Walk walk, float t) {
  for (int i = 0; i < MAX_STEPS; i++) {
    vec4 texel = texture2D(uNodes, texelAddress(walk.node, walk.texel_step));
    vec3 leave = floor(texel.xyz * (1.0 / NODE_GRID));
    vec3 enter = texel.xyz - leave * NODE_GRID;
    vec3 t0 = (enter - walk.origin) * walk.inverse;
    vec3 t1 = (leave - walk.origin) * walk.inverse;
    float first = max(max(t0.x, t0.y), max(t0.z, 0.0));
    float last = min(min(t1.x, t1.y), min(t1.z, t)) * BOX_SLACK;
    bool met = first <= last;
    walk.link = texel.w;
    walk.node = met || texel.w < 0.0 ? walk.node + 1.0 : texel.w;
    if (texel.w == 0.0 || (met && texel.w < 0.0)) break;
  }
}

Hit closestHit(vec3 origin, vec3 direction, bool wanted) {
  Walk walk = startWalk(origin, direction, wanted);
  Hit hit = Hit(TRIANGLE_NONE, FAR_AWAY, vec3(1.0), 0.0, 1.0);
  for (int i = 0; i < MAX_STEPS; i++) {
    walkToLeaf(walk, hit.t);
    if (walk.link >= 0.0) break;
    float index = -1.0 - walk.link;
    for (int k = 0; k < MAX_STEPS; k++) {
      TriangleData data = fetchTriangle(index);
      TriangleHit met = intersectTriangle(origin, direction, data.v0, data.v1, data.v2, hit.t);
      if (met.t >= 0.0) hit = Hit(index, met.t, met.volumes, data.material, data.area);
      if (data.last) break;
      index += 1.0;
    }
  }
  if (walk.link != 0.0) hit.triangle = TRIANGLE_UNKNOWN;
  return hit;
}

// 1 where nothing stands between the origin and `far` times the direction from there, 0 where
// something does, negative where the traversal was cut short.
float visibility(vec3 origin, vec3 direction, float far, bool wanted) {
  Walk walk = startWalk(origin, direction, wanted);
  bool blocked = false;
  for (int i = 0; i < MAX_STEPS; i++) {
    walkToLeaf(walk, far);
    if (walk.link >= 0.0) break;
    float index = -1.0 - walk.link;
    for (int k = 0; k < MAX_STEPS; k++) {
      TriangleData data = fetchTriangle(index);
      blocked = intersectTriangle(origin, direction, data.v0, data.v1, data.v2, far).t >= 0.0;
      if (blocked || data.last) break;
      index += 1.0;
    }
    if (blocked) break;
  }
  if (blocked) return 0.0;
  return walk.link == 0.0 ? 1.0 : -1.0;
}
