// The grid that the boxes of nodes are rounded to.
#pragma once

#include "renderer/bvh/bvh.h"

namespace glimt {

// Over the whole scene, with a cell to spare on each side. A flat scene gets flat cells, but not
// ones without any thickness.
class NodeGrid {
 public:
  // Of the root's box.
  explicit NodeGrid(const Bvh& bvh);

  Vec3 origin() const { return Vec3(origin_); }
  Vec3 cell() const { return Vec3(cell_); }  // metres

  // Whole coordinates, rounded outwards.
  Vec3 below(const Vec3& point) const;
  Vec3 above(const Vec3& point) const;

  // Two corners in three floats.
  static Vec3 packed(const Vec3& first, const Vec3& second);

 private:
  glm::dvec3 place(const Vec3& point) const { return (glm::dvec3(point) - origin_) / cell_; }

  glm::dvec3 origin_{0};
  glm::dvec3 cell_{1};
};

}  // namespace glimt
