// The geometry of an OBJ file as it stands there: polygons that refer to vertices and materials.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/core/vector.h"

namespace glimt {

struct ObjMesh {
  struct Corner {
    std::uint32_t position;
    std::uint32_t normal;    // kNoIndex: none given
    std::uint32_t texcoord;  // the same
  };
  struct Face {
    std::size_t first_corner;
    std::uint32_t corner_count;
    std::uint32_t material;  // into material_names; kNoIndex: none given
    std::size_t line;
  };

  std::vector<glm::dvec3> positions;  // NaN where the file has no number
  std::vector<Vec3> normals;
  std::vector<Vec2> texcoords;  // v running up
  std::vector<Corner> corners;  // not negative, but not checked against the sizes
  std::vector<Face> faces;
  std::vector<std::string> material_names;      // what `usemtl` lines name, once each
  std::vector<std::string> material_libraries;  // what follows `mtllib`, once each
};

// `path` is for messages. Errors: input, "PATH:LINE: what; what to do".
ObjMesh parseObj(std::string_view text, const std::string& path);

}  // namespace glimt
