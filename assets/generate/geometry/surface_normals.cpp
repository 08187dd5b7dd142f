#include "assets/generate/geometry/surface_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace glimt::assets {
namespace {

// Places closer than this are one.
constexpr double kSamePlace = 1e-6;

// For each position the number of its place; equal places have equal numbers.
std::vector<std::uint32_t> placesOf(const std::vector<dvec3>& positions) {
  const auto cell = [&](std::uint32_t i) {
    const dvec3 p = positions[i] / kSamePlace;
    return std::make_tuple(std::llround(p.x), std::llround(p.y), std::llround(p.z));
  };
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::make_tuple(cell(a), a) < std::make_tuple(cell(b), b);
  });
  std::vector<std::uint32_t> places(positions.size());
  std::uint32_t place = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && cell(order[k]) != cell(order[k - 1])) ++place;
    places[order[k]] = place;
  }
  return places;
}

struct Corner {
  std::uint32_t place;
  std::uint32_t triangle;
  int number;  // 0 to 2
};

double angleAt(const Mesh& mesh, const uvec3& triangle, int corner) {
  const dvec3& p = mesh.positions[triangle[corner]];
  const dvec3 a = glm::normalize(mesh.positions[triangle[(corner + 1) % 3]] - p);
  const dvec3 b = glm::normalize(mesh.positions[triangle[(corner + 2) % 3]] - p);
  return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

std::vector<dvec3> faceNormals(const Mesh& mesh) {
  std::vector<dvec3> normals;
  for (const uvec3& t : mesh.triangles) {
    const dvec3& p = mesh.positions[t.x];
    normals.push_back(glm::normalize(glm::cross(mesh.positions[t.y] - p, mesh.positions[t.z] - p)));
  }
  return normals;
}

// Vertices that share a position and nearly the normal are written once.
class VertexPool {
 public:
  VertexPool(const Mesh& mesh, ShadedMesh& result)
      : mesh_(mesh), result_(result), written_(mesh.positions.size()) {}

  std::uint32_t vertex(std::uint32_t position, const dvec3& normal) {
    for (const std::uint32_t known : written_[position])
      if (glm::dot(result_.normals[known], normal) > 1 - 1e-9) return known;
    const auto added = static_cast<std::uint32_t>(result_.positions.size());
    result_.positions.push_back(mesh_.positions[position]);
    result_.normals.push_back(normal);
    if (!mesh_.texture_coordinates.empty())
      result_.texture_coordinates.push_back(mesh_.texture_coordinates[position]);
    written_[position].push_back(added);
    return added;
  }

 private:
  const Mesh& mesh_;
  ShadedMesh& result_;
  std::vector<std::vector<std::uint32_t>> written_;
};

}  // namespace

ShadedMesh shaded(const Mesh& mesh, double crease) {
  const auto places = placesOf(mesh.positions);
  const auto faces = faceNormals(mesh);
  std::vector<Corner> corners;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) corners.push_back({places[mesh.triangles[t][k]], t, k});
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.place < b.place; });

  ShadedMesh result;
  result.triangles.resize(mesh.triangles.size());
  VertexPool pool(mesh, result);
  const double limit = std::cos(glm::radians(crease));
  for (auto first = corners.begin(); first != corners.end();) {
    const auto end = std::find_if(first, corners.end(),
                                  [&](const Corner& c) { return c.place != first->place; });
    for (auto corner = first; corner != end; ++corner) {
      const dvec3& own = faces[corner->triangle];
      dvec3 sum = own * 1e-6;
      for (auto other = first; other != end; ++other)
        if (glm::dot(faces[other->triangle], own) > limit)
          sum += faces[other->triangle] *
                 angleAt(mesh, mesh.triangles[other->triangle], other->number);
      const std::uint32_t position = mesh.triangles[corner->triangle][corner->number];
      result.triangles[corner->triangle][corner->number] =
          pool.vertex(position, glm::normalize(sum));
    }
    first = end;
  }
  return result;
}

}  // namespace glimt::assets
