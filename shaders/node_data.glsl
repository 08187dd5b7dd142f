// The tree's texture, laid out as layout.h says. A fetch costs more than the arithmetic to unpack it,
// so a node is one texel: its box is rounded outwards to a grid, twelve bits a coordinate. The ray
// is moved to the grid once.
uniform sampler2D uNodes;
uniform vec2 uNodesStep;
uniform vec3 uGridOrigin;
uniform vec3 uGridCell;  // metres

// The two corners of a node's box, on the grid.
struct Corners {
  vec3 first;
  vec3 second;
};

Corners unpackCorners(vec3 packed_corners) {
  vec3 second = floor(packed_corners * (1.0 / NODE_GRID));
  return Corners(packed_corners - second * NODE_GRID, second);
}

// A ray so that its distance to a plane of the grid is plane * inverse + offset. Written with a sum:
// of a difference, Mesa calculates the subtrahend again at each turn of a loop.
struct GridRay {
  vec3 inverse;
  vec3 offset;
};

GridRay rayOnGrid(vec3 origin, vec3 direction) {
  vec3 inverse = inverseOf(direction);
  return GridRay(inverse * uGridCell, (uGridOrigin - origin) * inverse);
}
