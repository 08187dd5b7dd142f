#include "renderer/scene/obj_mesh.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "renderer/core/error.h"
#include "renderer/core/wording.h"
#include "renderer/scene/obj_lines.h"
#include "renderer/scene/scene.h"

namespace glimt {
namespace {

// A byte of text can take some twenty of memory: these bound it to less than 2 GiB, and are several
// times what the renderer's textures take.
constexpr std::size_t kMostFaces = 1 << 23;
constexpr std::size_t kMostCorners = 1 << 25;
constexpr std::size_t kMostVertices = 1 << 24;
// Names are longer than numbers, and few.
constexpr std::size_t kMostNames = 1 << 16;

std::string_view takeWord(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(" \t"));
  text.remove_prefix(word.size());
  return word;
}

// In any locale. NaN for what is no number.
double numberIn(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (rest != end || error == std::errc::invalid_argument) return std::nan("");
  if (error == std::errc()) return value;
  const bool too_small = word.find("e-") != word.npos || word.find("E-") != word.npos;
  return too_small ? 0 : HUGE_VAL;
}

// What tinyobjloader calls, line by line. It gives faces and names. Its numbers are floats, which
// do not resolve a model far from the origin, and "nan", "inf" and "1.#IND" become 0 or 1; so they
// are read here.
class Collector : public tinyobj::MaterialReader {
 public:
  Collector(std::string_view text, const std::string& path) : lines_(text), path_(path) {}

  ObjMesh collect() {
    tinyobj::callback_t callback;
    callback.vertex_cb = [](void* self, float, float, float, float) {
      static_cast<Collector*>(self)->addPosition();
    };
    callback.normal_cb = [](void* self, float, float, float) {
      static_cast<Collector*>(self)->addNormal();
    };
    callback.texcoord_cb = [](void* self, float, float, float) {
      static_cast<Collector*>(self)->addTexcoord();
    };
    callback.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
      static_cast<Collector*>(self)->addFace(corners, count);
    };
    callback.usemtl_cb = [](void* self, const char* name, int) {
      static_cast<Collector*>(self)->useMaterial(name);
    };
    std::istream stream(&lines_);
    // What is thrown while a line is fetched would else end in the stream's state.
    stream.exceptions(std::ios::badbit);
    std::string ignored_warnings;
    std::string ignored_errors;
    tinyobj::LoadObjWithCallback(stream, callback, this, this, &ignored_warnings, &ignored_errors);
    return std::move(mesh_);
  }

  // tinyobjloader splits an mtllib line at blanks and swallows backslashes, so the line is kept as
  // it stands.
  bool operator()(const std::string&, std::vector<tinyobj::material_t>*,
                  std::map<std::string, int>*, std::string*, std::string*) override {
    std::string_view rest = lines_.line();
    takeWord(rest);
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    std::vector<std::string>& libraries = mesh_.material_libraries;
    if (is_library_.insert(std::string(rest)).second) {
      demandFewer(libraries.size(), kMostNames, "material files");
      libraries.emplace_back(rest);
    }
    return true;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorKind::input, fmt::format("{}:{}: {}", path_, lines_.number(), what));
  }

  void demandFewer(std::size_t count, std::size_t most, const char* what) const {
    if (count < most) return;
    fail(fmt::format("more than {} {}; use a coarser model", grouped(most), what));
  }

  // The line's three numbers, NaN for each that is none.
  glm::dvec3 vectorOfLine() const {
    std::string_view rest = lines_.line();
    takeWord(rest);
    glm::dvec3 value{0};
    for (int axis = 0; axis < 3; ++axis) value[axis] = numberIn(takeWord(rest));
    return value;
  }

  void addPosition() {
    std::string_view rest = lines_.line();
    for (int i = 0; i < 4; ++i) {
      if (takeWord(rest).empty()) fail("a vertex needs three numbers; export the model again");
    }
    demandFewer(mesh_.positions.size(), kMostVertices, "vertices");
    mesh_.positions.push_back(vectorOfLine());
  }

  void addNormal() {
    demandFewer(mesh_.normals.size(), kMostVertices, "normals");
    mesh_.normals.emplace_back(vectorOfLine());
  }

  // The second number may be missing: then it is 0.
  void addTexcoord() {
    demandFewer(mesh_.texcoords.size(), kMostVertices, "texture coordinates");
    std::string_view rest = lines_.line();
    takeWord(rest);
    const double u = numberIn(takeWord(rest));
    const std::string_view v = takeWord(rest);
    mesh_.texcoords.emplace_back(u, v.empty() ? 0 : numberIn(v));
  }

  // From OBJ's count, which begins at 1 and runs backwards when negative.
  std::uint32_t indexOf(int number, std::size_t count, const char* what) const {
    if (number > 0) return static_cast<std::uint32_t>(number - 1);
    const auto index = static_cast<std::int64_t>(count) + number;
    if (number == 0) {
      fail(fmt::format("a corner of the face is no {} number; they count from 1", what));
    }
    if (index < 0) {
      fail(fmt::format(
          "the face goes back to {} {}, but only {} came before; export the model again", what,
          number, count));
    }
    return static_cast<std::uint32_t>(index);
  }

  // A wrong one costs a face its texture, not the file: it becomes one that is out of range.
  std::uint32_t texcoordOf(int number) const {
    if (number == 0) return kNoIndex;
    const bool too_far_back =
        number < 0 && static_cast<std::int64_t>(mesh_.texcoords.size()) + number < 0;
    return too_far_back ? kNoIndex - 1
                        : indexOf(number, mesh_.texcoords.size(), "texture coordinate");
  }

  void addFace(const tinyobj::index_t* corners, int count) {
    demandFewer(mesh_.faces.size(), kMostFaces, "faces");
    demandFewer(mesh_.corners.size() + static_cast<std::size_t>(count), kMostCorners, "corners");
    ObjMesh::Face face{};
    face.first_corner = mesh_.corners.size();
    face.corner_count = static_cast<std::uint32_t>(count);
    face.material = material_;
    face.line = lines_.number();
    for (int i = 0; i < count; ++i) {
      const tinyobj::index_t& corner = corners[i];
      const std::uint32_t position = indexOf(corner.vertex_index, mesh_.positions.size(), "vertex");
      // tinyobjloader says 0 where nothing is given.
      const std::uint32_t normal =
          corner.normal_index == 0 ? kNoIndex
                                   : indexOf(corner.normal_index, mesh_.normals.size(), "normal");
      const std::uint32_t texcoord = texcoordOf(corner.texcoord_index);
      mesh_.corners.push_back({position, normal, texcoord});
    }
    mesh_.faces.push_back(face);
  }

  void useMaterial(std::string_view name) {
    name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
    const auto next = static_cast<std::uint32_t>(mesh_.material_names.size());
    const auto [entry, is_new] = material_of_name_.try_emplace(std::string(name), next);
    if (is_new) {
      demandFewer(next, kMostNames, "materials");
      mesh_.material_names.emplace_back(name);
    }
    material_ = entry->second;
  }

  ObjLines lines_;
  const std::string& path_;
  ObjMesh mesh_;
  std::uint32_t material_ = kNoIndex;
  std::unordered_map<std::string, std::uint32_t> material_of_name_;
  std::unordered_set<std::string> is_library_;
};

}  // namespace

ObjMesh parseObj(std::string_view text, const std::string& path) {
  return Collector(text, path).collect();
}

}  // namespace glimt
