#include "renderer/scene/obj_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/wording.h"
#include "renderer/scene/mtl_file.h"
#include "renderer/scene/mtl_images.h"
#include "renderer/scene/obj_lines.h"
#include "renderer/scene/obj_mesh.h"
#include "renderer/scene/path_beside.h"
#include "renderer/scene/polygon.h"
#include "renderer/scene/scene_origin.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

// Several times what fits into the renderer's textures; with the mesh below 2 GiB of memory.
constexpr std::uintmax_t kLargestObj = 512 << 20;
constexpr std::size_t kMostLibraries = 100;
constexpr std::size_t kMostTriangles = 1 << 23;

// What may be one name with blanks, or several names, or one with escaped blanks.
std::vector<std::string> namesIn(const std::string& line) {
  std::vector<std::string> names = {""};
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool escaped = line[i] == '\\' && i + 1 < line.size() && line[i + 1] == ' ';
    if (escaped) {
      names.back() += line[++i];
    } else if (line[i] != ' ' && line[i] != '\t') {
      names.back() += line[i];
    } else if (!names.back().empty()) {
      names.emplace_back();
    }
  }
  if (names.back().empty()) names.pop_back();
  return names;
}

// Those that are there. Looks for no more than kMostLibraries: a line may hold a million names.
std::vector<fs::path> librariesOf(const ObjMesh& mesh, const fs::path& folder,
                                  std::vector<std::string>& missing) {
  std::vector<fs::path> paths;
  for (const std::string& line : mesh.material_libraries) {
    if (paths.size() + missing.size() >= kMostLibraries) break;
    if (const fs::path whole = pathBeside(folder, line); !whole.empty()) {
      paths.push_back(whole);
      continue;
    }
    for (const std::string& name : namesIn(line)) {
      if (paths.size() + missing.size() >= kMostLibraries) return paths;
      const fs::path path = pathBeside(folder, name);
      if (path.empty()) {
        missing.push_back(name);
      } else {
        paths.push_back(path);
      }
    }
  }
  return paths;
}

std::vector<MtlMaterial> readLibraries(const ObjMesh& mesh, const fs::path& folder,
                                       std::vector<std::string>& warnings) {
  std::vector<MtlMaterial> materials;
  std::vector<std::string> missing;
  for (const fs::path& path : librariesOf(mesh, folder, missing)) {
    try {
      for (MtlMaterial& material : readMtlFile(path)) materials.push_back(std::move(material));
    } catch (const Error& error) {
      warnings.push_back(fmt::format("materials left out: {}", error.what()));
    }
  }
  if (!missing.empty()) {
    warnings.push_back(fmt::format("no material file {} beside the model", listed(missing)));
  }
  return materials;
}

void warnAbout(const std::vector<MtlMaterial>& used, std::vector<std::string>& warnings) {
  std::vector<std::string> ignored;
  for (const MtlMaterial& m : used) {
    if (m.has_other_textures) ignored.push_back(m.material.name);
  }
  if (!ignored.empty()) {
    warnings.push_back(fmt::format(
        "the MTL names textures of kinds that have no place in the material, of {}; use map_Kd, "
        "map_d, map_Ke, map_Pr, map_Pm or norm",
        listed(ignored)));
  }
}

// Fills scene.materials; returns where in it each of the mesh's material names is. A name that no
// library has gets a grey material, so that a scene file can still say what it is.
std::vector<std::uint32_t> resolveMaterials(const ObjMesh& mesh, const fs::path& folder,
                                            Scene& scene) {
  const std::vector<MtlMaterial> library = readLibraries(mesh, folder, scene.warnings);
  std::unordered_map<std::string, std::size_t> library_index;
  for (std::size_t i = 0; i < library.size(); ++i) {
    // When a name comes twice, the first one is meant.
    if (library_index.try_emplace(library[i].material.name, i).second) {
      scene.materials.push_back(library[i].material);
    }
  }
  std::unordered_map<std::string, std::uint32_t> scene_index;
  for (const Material& material : scene.materials) {
    scene_index.emplace(material.name, static_cast<std::uint32_t>(scene_index.size()));
  }

  std::vector<std::uint32_t> resolved;
  std::vector<MtlMaterial> used;
  std::vector<std::string> undefined;
  MtlImages images(folder, scene);
  for (const std::string& name : mesh.material_names) {
    const auto found = scene_index.find(name);
    if (found != scene_index.end()) {
      resolved.push_back(found->second);
      used.push_back(library[library_index.at(name)]);
      images.addTo(scene.materials[found->second], used.back().textures);
      continue;
    }
    resolved.push_back(static_cast<std::uint32_t>(scene.materials.size()));
    scene.materials.emplace_back().name = name;
    undefined.push_back(name);
  }
  if (!undefined.empty()) {
    scene.warnings.push_back(
        fmt::format("no material file defines {}; rendered grey", listed(undefined)));
  }
  images.warn();
  warnAbout(used, scene.warnings);
  return resolved;
}

glm::dvec3 originOf(const ObjMesh& mesh) {
  glm::dvec3 low(HUGE_VAL);
  glm::dvec3 high(-HUGE_VAL);
  for (const ObjMesh::Corner& corner : mesh.corners) {
    const glm::dvec3& position = mesh.positions[corner.position];
    if (!std::isfinite(position.x + position.y + position.z)) continue;
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  return sceneOriginOf(low, high);
}

void placeVertices(const ObjMesh& mesh, Scene& scene) {
  scene.origin = originOf(mesh);
  scene.positions.reserve(mesh.positions.size());
  for (const glm::dvec3& position : mesh.positions)
    scene.positions.emplace_back(position - scene.origin);
}

// OBJ's v runs up.
void placeTexcoords(const ObjMesh& mesh, Scene& scene) {
  scene.texcoords.reserve(mesh.texcoords.size());
  for (const Vec2& at : mesh.texcoords)
    scene.texcoords.push_back({{Vec2(at.x, 1 - at.y), Vec2(0)}});
}

// How many faces had to be left as they are not, and the effort that is left for concave ones.
struct FaceFlaws {
  std::size_t too_few_corners = 0;
  std::size_t normal_out_of_range = 0;
  std::size_t texcoord_out_of_range = 0;
  std::int64_t effort = kEffortForFile;
};

void addFace(const ObjMesh& mesh, const ObjMesh::Face& face, std::uint32_t material, Scene& scene,
             FaceFlaws& flaws) {
  const ObjMesh::Corner* corners = mesh.corners.data() + face.first_corner;
  std::vector<Vec3> points;
  bool normals_in_range = true;
  bool texcoords_in_range = true;
  for (std::uint32_t i = 0; i < face.corner_count; ++i) {
    points.push_back(scene.positions[corners[i].position]);
    const std::uint32_t normal = corners[i].normal;
    normals_in_range = normals_in_range && (normal == kNoIndex || normal < mesh.normals.size());
    const std::uint32_t texcoord = corners[i].texcoord;
    texcoords_in_range =
        texcoords_in_range && (texcoord == kNoIndex || texcoord < mesh.texcoords.size());
  }
  if (face.corner_count < 3) ++flaws.too_few_corners;
  if (!normals_in_range) ++flaws.normal_out_of_range;
  if (!texcoords_in_range) ++flaws.texcoord_out_of_range;
  for (const auto& cut : triangulate(points, flaws.effort)) {
    Triangle triangle;
    triangle.material = material;
    for (std::size_t k = 0; k < 3; ++k) {
      const ObjMesh::Corner& corner = corners[cut[k]];
      triangle.positions[k] = corner.position;
      triangle.normals[k] = normals_in_range ? corner.normal : kNoIndex;
      triangle.texcoords[k] = texcoords_in_range ? corner.texcoord : kNoIndex;
    }
    scene.triangles.push_back(triangle);
  }
}

void demandVertices(const ObjMesh& mesh, const std::string& path) {
  for (const ObjMesh::Face& face : mesh.faces) {
    for (std::uint32_t i = 0; i < face.corner_count; ++i) {
      const std::uint32_t position = mesh.corners[face.first_corner + i].position;
      if (position < mesh.positions.size()) continue;
      throw Error(ErrorKind::input,
                  fmt::format("{}:{}: the face uses vertex {}, but the file has {}; export the "
                              "model again",
                              path, face.line, position + std::uint64_t{1}, mesh.positions.size()));
    }
  }
}

ObjMesh readMesh(const fs::path& path, const std::string& shown_path) {
  const std::string bytes = readFile(path, kLargestObj);
  return parseObj(demandText(bytes, shown_path), shown_path);
}

void demandFewer(const Scene& scene, const ObjMesh::Face& face, const std::string& path) {
  if (scene.triangles.size() <= kMostTriangles) return;
  throw Error(ErrorKind::input, fmt::format("{}:{}: more than {} triangles; use a coarser model",
                                            path, face.line, grouped(kMostTriangles)));
}

}  // namespace

Scene readObjFile(const fs::path& path) {
  const std::string shown_path = printable(path.string());
  ObjMesh mesh = readMesh(path, shown_path);
  if (mesh.faces.empty()) {
    throw Error(
        ErrorKind::input,
        fmt::format("{}: the model has no faces; export it with faces, as OBJ", shown_path));
  }
  demandVertices(mesh, shown_path);

  Scene scene;
  scene.name = path.stem().string();
  placeVertices(mesh, scene);
  const std::vector<std::uint32_t> materials = resolveMaterials(mesh, path.parent_path(), scene);
  std::optional<std::uint32_t> without_material;
  FaceFlaws flaws;
  for (const ObjMesh::Face& face : mesh.faces) {
    if (face.material == kNoIndex && !without_material) {
      without_material = static_cast<std::uint32_t>(scene.materials.size());
      scene.materials.emplace_back().name = "default";
    }
    const std::uint32_t material =
        face.material == kNoIndex ? *without_material : materials[face.material];
    addFace(mesh, face, material, scene, flaws);
    demandFewer(scene, face, shown_path);
  }
  scene.normals = std::move(mesh.normals);
  // Where nothing is looked up, coordinates would only take memory.
  if (!scene.images.empty()) placeTexcoords(mesh, scene);
  if (flaws.effort <= 0) {
    scene.warnings.push_back(
        "too many corners in faces that are not convex; some may be cut wrongly");
  }
  if (flaws.too_few_corners > 0) {
    scene.warnings.push_back(fmt::format("dropped {} of less than three corners",
                                         counted(flaws.too_few_corners, "face")));
  }
  if (flaws.normal_out_of_range > 0) {
    scene.warnings.push_back(fmt::format("shaded {} flat: a normal that the file does not have",
                                         counted(flaws.normal_out_of_range, "face")));
  }
  if (flaws.texcoord_out_of_range > 0 && !scene.images.empty()) {
    scene.warnings.push_back(
        fmt::format("left {} without a texture: coordinates that the file does not have",
                    counted(flaws.texcoord_out_of_range, "face")));
  }
  return scene;
}

}  // namespace glimt
