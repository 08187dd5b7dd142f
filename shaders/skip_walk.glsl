// The walk along skip links: a box that is met leads to the next node, a box that is missed to the node
// behind its subtree. Nodes are depth first, and end with one that counts as a leaf whether it is met
// or not, so that walking needs one test.
uniform float uNodesPerCopy;  // with the one at the end

struct Walk {
  GridRay ray;
  vec2 texel_step;  // a uniform that is read inside a loop is read again at each turn
  float node;       // the next to visit
  float link;
};

// Within the copy of the tree that begins at `start`.
Walk walkFrom(float start, vec3 origin, vec3 direction, bool wanted) {
  return Walk(rayOnGrid(origin, direction), uNodesStep,
              start + (wanted ? 0.0 : uNodesPerCopy - 1.0), 1.0);
}
