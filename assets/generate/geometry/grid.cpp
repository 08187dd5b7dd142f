#include "assets/generate/geometry/grid.h"

namespace glimt::assets {
namespace {

// Two quarters of a quad, without those that have no area.
void addQuad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  constexpr double kSmallestArea = 1e-14;  // square metres, doubled
  for (const uvec3& triangle : {uvec3(a, b, c), uvec3(a, c, d)}) {
    const dvec3& corner = mesh.positions[triangle.x];
    const dvec3 normal =
        glm::cross(mesh.positions[triangle.y] - corner, mesh.positions[triangle.z] - corner);
    if (glm::length(normal) > kSmallestArea) mesh.triangles.push_back(triangle);
  }
}

// A fan over a ring, turned towards where the ring is counter-clockwise from.
void addCap(Mesh& mesh, const std::vector<dvec3>& ring, bool reversed) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto count = static_cast<std::uint32_t>(ring.size());
  dvec3 middle(0);
  for (const dvec3& point : ring) {
    mesh.positions.push_back(point);
    middle += point / static_cast<double>(count);
  }
  mesh.positions.push_back(middle);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t here = first + i, next = first + (i + 1) % count;
    mesh.triangles.push_back(reversed ? uvec3(next, here, first + count)
                                      : uvec3(here, next, first + count));
  }
}

}  // namespace

Mesh grid(int columns, int rows, Edges columns_end, Edges rows_end,
          const std::function<dvec3(int, int)>& at) {
  const int across = columns_end == Edges::closed ? columns : columns + 1;
  const int up = rows_end == Edges::closed ? rows : rows + 1;
  Mesh mesh;
  mesh.positions.reserve(static_cast<std::size_t>(across) * up);
  for (int j = 0; j < up; ++j)
    for (int i = 0; i < across; ++i) mesh.positions.push_back(at(i, j));
  const auto index = [&](int i, int j) {
    return static_cast<std::uint32_t>((j % up) * across + i % across);
  };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      addQuad(mesh, index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
  return mesh;
}

Mesh texturedGrid(int columns, int rows, const dvec2& repeat,
                  const std::function<dvec3(int, int)>& at) {
  Mesh mesh = grid(columns, rows, Edges::open, Edges::open, at);
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      mesh.texture_coordinates.push_back(
          repeat * dvec2(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
  return mesh;
}

Mesh loft(const std::vector<std::vector<dvec3>>& rings, bool capped) {
  const int around = static_cast<int>(rings.front().size());
  const int along = static_cast<int>(rings.size()) - 1;
  Mesh mesh =
      grid(around, along, Edges::closed, Edges::open, [&](int i, int j) { return rings[j][i]; });
  if (capped) {
    addCap(mesh, rings.front(), true);
    addCap(mesh, rings.back(), false);
  }
  return mesh;
}

}  // namespace glimt::assets
