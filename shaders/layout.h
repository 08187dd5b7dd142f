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
//   2: vertex 2 x, y, z; 1 if light may pass it although it is hit (alpha.glsl), else 0
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
//   3: what absorbs inside, r, g, b, per metre, 0 where light does not get in; 1 if
//   thin-walled, else 0
//   4: clear coat, its roughness, roughness of the sheen, square of gloss_albedo.glsl for
//   rough glass
//   5: colour of the sheen r, g, b; 1 for a shadow catcher, else 0
//   6: alpha; below which alpha it is a hole, negative where alpha is a share; scale of the normal
//   map; 1 where vertex colours multiply the emission
//   from TEXTURE_USES on: the uses of pictures, in the order of the *_TEXTURE below
#define MATERIAL_TEXELS 34.0
#define TEXTURE_FACTORS 6.0
#define TEXTURE_USES 7.0

// One use of a picture.
//   0: its rectangle in the atlas, in texels: x, y of its upper left corner, width, 0 where there
//   is none; height
//   1: texture coordinates to the picture's: coefficients of u, v in its u, in its v
//   2: the sum's constants in u, in v; wraps, that of u + 4 * that of v (texture_wrap.glsl), + 16
//   for the nearest filter; set of texture coordinates
#define TEXTURE_USE_TEXELS 3.0
#define BASE_COLOR_TEXTURE 0.0
#define METALLIC_ROUGHNESS_TEXTURE 1.0
#define EMISSION_TEXTURE 2.0
#define NORMAL_TEXTURE 3.0
#define TRANSMISSION_TEXTURE 4.0
#define CLEARCOAT_TEXTURE 5.0
#define CLEARCOAT_ROUGHNESS_TEXTURE 6.0
#define SHEEN_COLOR_TEXTURE 7.0
#define SHEEN_ROUGHNESS_TEXTURE 8.0

// Vertex attributes of a triangle, only where the scene has any.
//   0: texture coordinates, set 0, of vertex 0, of vertex 1
//   1: set 0 of vertex 2; set 1 of vertex 2
//   2: set 1 of vertex 0, of vertex 1
//   3, 4, 5, only where the scene has vertex colours: r, g, b, alpha of vertex 0, 1, 2
#define TEXCOORD_TEXELS 3.0
#define COLOR_TEXELS 3.0

// Side of the squares in the table of gloss_albedo.glsl.
#define GLOSS_TABLE_SIZE 64.0

// Lights, an alias table; see light_table.glsl. One texel each:
//   share of the entry that goes to its own triangle, index of that, index of the other one, free

// Lights without triangles; see punctual_lights.glsl.
//   0: position x, y, z; 1, or unit direction towards the light x, y, z; 0
//   1: intensity r, g, b, or irradiance; probability of choosing it
//   2: unit direction in which it shines x, y, z; 1 / range^2, 0 for none
//   3: a spot's brightness is (second + first * cosine)^2, within 0 and 1; of the alias table:
//   share of the entry that goes to its own light, index of the other one
#define PUNCTUAL_LIGHT_TEXELS 4.0

// The fourth channel of a sample's radiance where the background is transparent: what the camera's
// ray has met; see coverage.glsl.
#define SEEN_SURFACE 1.0
#define SEEN_CATCHER 2.0

// Samples that are summed before they become part of the mean: enough that the mean is updated
// seldom, few enough that the sum is exact to 3e-6. See sample_mean.glsl.
#define SAMPLES_PER_BLOCK 128

// Side of the squares of pixels over which changes of the picture are summed; see change.glsl.
#define CHANGE_SQUARE 8

// Sequences of sample points in a picture; see sample_points.glsl.
#define POINT_GROUPS 4

// Side of the square texture of sampling offsets, which is repeated over the picture.
#define OFFSETS_SIZE 256.0
