#include "assets/generate/geometry/mesh.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

namespace glimt::assets {

void append(Mesh& mesh, const Mesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  mesh.texture_coordinates.insert(mesh.texture_coordinates.end(), more.texture_coordinates.begin(),
                                  more.texture_coordinates.end());
  mesh.triangles.reserve(mesh.triangles.size() + more.triangles.size());
  for (const uvec3& triangle : more.triangles) mesh.triangles.push_back(triangle + first);
}

Mesh joined(const std::vector<Mesh>& meshes) {
  Mesh all;
  for (const Mesh& mesh : meshes) append(all, mesh);
  return all;
}

Mesh transformed(Mesh mesh, const dmat4& map) {
  for (dvec3& position : mesh.positions) position = dvec3(map * glm::dvec4(position, 1));
  if (glm::determinant(glm::dmat3(map)) < 0)
    for (uvec3& triangle : mesh.triangles) std::swap(triangle.y, triangle.z);
  return mesh;
}

dmat4 moved(const dvec3& by) {
  return glm::translate(dmat4(1), by);
}

dmat4 turned(double degrees, const dvec3& axis) {
  return glm::rotate(dmat4(1), glm::radians(degrees), axis);
}

dmat4 scaled(const dvec3& by) {
  return glm::scale(dmat4(1), by);
}

dmat4 pointing(const dvec3& at, const dvec3& direction) {
  const dvec3 up = glm::normalize(direction);
  const dvec3 reference = std::abs(up.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 0, 1);
  const dvec3 front = glm::normalize(glm::cross(reference, up));
  const dvec3 right = glm::cross(up, front);
  return {glm::dvec4(right, 0), glm::dvec4(up, 0), glm::dvec4(front, 0), glm::dvec4(at, 1)};
}

Mesh withMirrorImage(const Mesh& mesh) {
  Mesh both = mesh;
  append(both, transformed(mesh, scaled({1, 1, -1})));
  return both;
}

Mesh aroundAxis(const Mesh& mesh, int count, const dvec3& axis) {
  Mesh all;
  for (int i = 0; i < count; ++i) append(all, transformed(mesh, turned(360.0 * i / count, axis)));
  return all;
}

}  // namespace glimt::assets
