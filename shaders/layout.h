// The texel layout, written once: this file is read by C++ and by GLSL, so it holds nothing but
// definitions. Counts are texels of four floats.

// Nodes of the tree, one texel each. Boxes are on a grid over the scene: whole coordinates below
// NODE_GRID, two packed into one float as first + NODE_GRID * second.
//
// In depth-first order, ended by one more node (skip_walk.glsl). For ray octants there are eight
// copies, in which `first` is the corner where a ray enters.
//   x, y, z: the box; an inner node: index of the node that follows when its box is missed; a leaf:
//   -1 - index of its first triangle; the node at the end: 0
//
// In pairs (traverse_stack.glsl): the children of a node side by side. The root is the first of the
// pair at ROOT_PAIR, whose second has the same box and the link 0, which is the end.
//   x, y, z: the box; an inner node: index of its first child; a leaf: -1 - index of its first
//   triangle
//
// In triples (traverse_parent.glsl): the children of a node, and between them the way up. A link to
// children is the index of what is between them. The root is the lower node beside ROOT_TRIPLE.
//   a child: as in pairs, but of an inner node x, y or z is negative: the axis along which its
//   lower child comes first between: 0: of the node above, the index of what is beside it, negative
//   for a lower child, 0 at the root; 1 to 3: 1 for the axis of the node above, else 0
#define NODE_GRID 4096.0
#define ROOT_PAIR 2.0
#define ROOT_TRIPLE 1.0

// The deepest trees that the traversals hold, in levels of inner nodes with one for the end: places
// on a stack, bits of the trail in trail_float.glsl and in trail_bits.glsl.
#define STACK_SIZE 32
#define TRAIL_SIZE 44
#define TRAIL_BITS 32

// Turns of a traversal's loops, more than any sound tree asks for. A driver may stop earlier.
#define MAX_STEPS 65536

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
//   0: base colour r, g, b; metallic
//   1: emission r, g, b; density of light samples on the surface, per square metre, negative where
//   both sides emit
//   2: roughness, specular, ior, transmission
//   3: what absorbs inside, r, g, b, per metre, 0 where light does not get in; 1 if thin-walled, else 0
//   4: clear coat, its roughness, roughness of the sheen, square of gloss_albedo.glsl for rough glass
//   5: colour of the sheen r, g, b, free
#define MATERIAL_TEXELS 6.0

// Side of the squares in the table of gloss_albedo.glsl.
#define GLOSS_TABLE_SIZE 64.0

// Lights, an alias table; see light_table.glsl. One texel each:
//   share of the entry that goes to its own triangle, index of that, index of the other one, free

// Samples that are summed before they become part of the mean: enough that the mean is updated
// seldom, few enough that the sum is exact to 3e-6. See sample_mean.glsl.
#define SAMPLES_PER_BLOCK 128

// Side of the square texture of sampling offsets, which is repeated over the picture.
#define OFFSETS_SIZE 256.0
