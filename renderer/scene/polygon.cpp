#include "renderer/scene/polygon.h"

#include <algorithm>
#include <utility>

namespace glimt {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Newell's method: the direction that the polygon faces, and twice its area as the length.
glm::dvec3 newellNormal(const std::vector<Vec3>& points) {
  glm::dvec3 normal{0};
  const glm::dvec3 origin(points[0]);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 a = glm::dvec3(points[i]) - origin;
    const glm::dvec3 b = glm::dvec3(points[(i + 1) % points.size()]) - origin;
    normal += glm::cross(a, b);
  }
  return normal;
}

// The polygon in the coordinate plane that it faces most, counter-clockwise. Leaving out a
// coordinate rounds nothing.
std::vector<glm::dvec2> flattened(const std::vector<Vec3>& points) {
  const glm::dvec3 n = newellNormal(points);
  const glm::dvec3 size = glm::abs(n);
  int u = 0;
  int v = 1;
  if (size.x >= size.y && size.x >= size.z) {
    u = 1;
    v = 2;
  } else if (size.y >= size.z) {
    u = 2;
    v = 0;
  }
  const int left_out = 3 - u - v;
  if (n[left_out] < 0) std::swap(u, v);
  std::vector<glm::dvec2> flat;
  flat.reserve(points.size());
  for (const Vec3& p : points) flat.emplace_back(p[u], p[v]);
  return flat;
}

// Twice the signed area; positive when c lies to the left of the way from a to b.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool isConvex(const std::vector<glm::dvec2>& flat) {
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!(turn(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) >= 0)) return false;
  }
  return true;
}

Triangles splitQuad(const std::vector<Vec3>& points) {
  const glm::dvec3 d02 = glm::dvec3(points[2]) - glm::dvec3(points[0]);
  const glm::dvec3 d13 = glm::dvec3(points[3]) - glm::dvec3(points[1]);
  if (glm::dot(d02, d02) < glm::dot(d13, d13)) return {{0, 1, 2}, {0, 2, 3}};
  return {{0, 1, 3}, {1, 2, 3}};
}

// Halves the run of corners again and again: rounder triangles than a fan.
void splitConvex(std::uint32_t first, std::uint32_t last, Triangles& out) {
  if (last - first < 2) return;
  const std::uint32_t middle = first + (last - first) / 2;
  out.push_back({first, middle, last});
  splitConvex(first, middle, out);
  splitConvex(middle, last, out);
}

// Cuts ears off a polygon whose corners are linked in a ring.
class EarCutter {
 public:
  EarCutter(const std::vector<glm::dvec2>& flat, std::int64_t& comparisons)
      : flat_(flat), next_(flat.size()), previous_(flat.size()), comparisons_(comparisons) {
    const auto n = static_cast<std::uint32_t>(flat.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      previous_[i] = (i + n - 1) % n;
    }
  }

  Triangles cut() {
    Triangles out;
    std::uint32_t corner = 0;
    std::size_t tried = 0;
    for (std::size_t left = flat_.size(); left > 2;) {
      // A ring without ears crosses itself: take any corner and go on.
      if (tried < left && !isEar(corner)) {
        ++tried;
        corner = next_[corner];
        continue;
      }
      out.push_back({previous_[corner], corner, next_[corner]});
      next_[previous_[corner]] = next_[corner];
      previous_[next_[corner]] = previous_[corner];
      corner = next_[next_[corner]];
      tried = 0;
      --left;
    }
    return out;
  }

 private:
  bool isEar(std::uint32_t corner) {
    const glm::dvec2& a = flat_[previous_[corner]];
    const glm::dvec2& b = flat_[corner];
    const glm::dvec2& c = flat_[next_[corner]];
    if (--comparisons_ <= 0) return true;
    if (!(turn(a, b, c) > 0)) return false;
    for (std::uint32_t i = next_[next_[corner]]; i != previous_[corner]; i = next_[i]) {
      if (--comparisons_ <= 0) return true;
      const glm::dvec2& p = flat_[i];
      // A corner that touches another one (a hole cut open along a bridge) does not block it.
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  const std::vector<glm::dvec2>& flat_;
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> previous_;
  std::int64_t& comparisons_;  // that are left
};

}  // namespace

Triangles triangulate(const std::vector<Vec3>& points, std::int64_t& effort) {
  if (points.size() < 3) return {};
  if (points.size() == 3) return {{0, 1, 2}};
  const std::vector<glm::dvec2> flat = flattened(points);
  if (!isConvex(flat)) {
    // One absurd polygon leaves something for the others.
    std::int64_t comparisons = std::min(effort, kEffortForPolygon);
    effort -= comparisons;
    Triangles cut = EarCutter(flat, comparisons).cut();
    effort += std::max<std::int64_t>(comparisons, 0);
    return cut;
  }
  if (points.size() == 4) return splitQuad(points);
  Triangles out;
  out.reserve(points.size() - 2);
  splitConvex(0, static_cast<std::uint32_t>(points.size() - 1), out);
  return out;
}

}  // namespace glimt
