// Surfaces with two parameters, as a grid of quads.
#pragma once

#include <functional>

#include "assets/generate/geometry/mesh.h"

namespace glimt::assets {

enum class Edges { open, closed };  // closed: the last column or row meets the first

// Points at(i, j) for i in [0, columns] and j in [0, rows], the last of a closed direction left
// out. Outside is where i goes to the right and j up. Quads whose sides have no length become
// triangles or nothing, so a row may shrink to a point.
Mesh grid(int columns, int rows, Edges columns_end, Edges rows_end,
          const std::function<dvec3(int, int)>& at);

// The same, open, with texture coordinates (i / columns, j / rows) times `repeat`.
Mesh texturedGrid(int columns, int rows, const dvec2& repeat,
                  const std::function<dvec3(int, int)>& at);

// A skin over closed rings of equally many points, each counter-clockwise seen from the ring
// after it, with flat ends where `capped`.
Mesh loft(const std::vector<std::vector<dvec3>>& rings, bool capped);

}  // namespace glimt::assets
