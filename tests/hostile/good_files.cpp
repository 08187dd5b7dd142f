#include "tests/hostile/good_files.h"

#include <iterator>

namespace glimt {
namespace {

constexpr const char* kBox = R"(# a box with normals, quads, and negative indices
mtllib box.mtl
o box
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
vn 0 0 -1
vn 0 0 1
vt 0 0
vt 1 1
usemtl red
f 4/1/1 3/2/1 2//1 1//1
f -4//2 -3//2 -2//2 -1//2
usemtl lamp
s 1
f 1 2 6 5
f 4 8 7 3
g side wall
f 2 3 7 6
f 1 5 8 4
)";

constexpr const char* kPolygons = R"(v 0 0 0
v 2 0 0
v 2 2 0 # a concave corner follows
v 1 0.5 0
v 0 2 0
v 1e-3 -1.5E+2 +.25
vn 0.6 0.8 0
f 1 2 3 \
  4 5
f 1//1 2//1 6//1
l 1 2
p 3
)";

constexpr const char* kColors = R"(newmtl red
Ka 0 0 0
Kd 0.8 0.1 0.1
Ks 0.5 0.5 0.5
Ns 20
illum 2
newmtl lamp
Ke 17 12 4
d 0.5
Tr 0.5
Ni 1.45
)";

constexpr const char* kTextures = R"(# names with blanks, and pictures
newmtl a painted wall
map_Kd -s 1 1 1 -o 0 0 0 -mm 0 1 wall.png
bump -bm 0.2 wall_bump.png
Pr 0.5
Pm 1.0
newmtl plain
Kd 0.5
map_Ke -clamp on glow.png
)";

constexpr const char* kWholeScene = R"({
  "model": "scene.obj",
  "camera": {"position": [0, 1, 5], "target": [0, 0.5, 0], "up": [0, 1, 0], "vertical_fov": 40.5},
  "environment": {"color": [0.5, 0.25, 1e-1], "strength": 2, "rotation": -90},
  "materials": {"a": {"base_color": [0.1, 0.2, 0.3], "emission": [1, 2, 3], "double_sided": false,
                      "metallic": 0, "roughness": 1, "ior": 1.5, "transmission": 0,
                      "clearcoat": 0.5}},
  "render": {"size": [64, 32], "bounces": 2, "exposure": -0.5}
}
)";

}  // namespace

std::vector<GoodFile> goodFiles() {
  std::vector<GoodFile> files = {
      {"obj", "box.obj", kBox},
      {"obj", "polygons.obj", kPolygons},
      {"mtl", "colors.mtl", kColors},
      {"mtl", "textures.mtl", kTextures},
      {"json", "whole.scene.json", kWholeScene},
      {"json", "least.scene.json", R"({"model":"scene.obj","environment":{}})"},
  };
  for (std::vector<GoodFile> more : {goodGltfs(), goodPictures()})
    files.insert(files.end(), std::make_move_iterator(more.begin()),
                 std::make_move_iterator(more.end()));
  return files;
}

}  // namespace glimt
