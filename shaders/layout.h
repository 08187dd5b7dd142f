// The texel layout, written once: this file is read by C++ and by GLSL, so it holds nothing but
// definitions. Counts are texels of four floats.

// Nodes, one copy of the tree for each of the eight ray octants; see traverse_octant.glsl. One
// texel each. Boxes are on a grid over the scene: whole coordinates below NODE_GRID.
//   enter + NODE_GRID * leave, for x, y, z: of the corners where a ray enters and leaves the box;
//   an inner node: index of the node that follows when its box is missed; a leaf: -1 - index of its
//   first triangle; the node at the end: 0
#define NODE_GRID 4096.0

// Triangles in leaf order; see triangle_data.glsl.
//   0: vertex 0 x, y, z; 1 + material index, negative for the last triangle of a leaf
//   1: vertex 1 x, y, z; area
//   2: vertex 2 x, y, z; free
#define TRIANGLE_TEXELS 3.0

// Shading normals of a triangle, only where the scene has any.
//   0: octahedral normal of vertex 0, of vertex 1
//   1: octahedral normal of vertex 2; 1 if the triangle is smooth, else 0; free
#define NORMAL_TEXELS 2.0

// Materials.
//   0: base colour r, g, b; free
//   1: emission r, g, b; density of light samples on the surface, per square metre, negative where
//   both sides emit
#define MATERIAL_TEXELS 2.0

// Lights, an alias table; see light_table.glsl. One texel each:
//   share of the entry that goes to its own triangle, index of that, index of the other one, free

// Side of the square texture of sampling offsets, which is repeated over the picture.
#define OFFSETS_SIZE 256.0
