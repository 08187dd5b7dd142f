// Writes default.obj: a still life on a curved backdrop, lit by two panels. README.md says how to
// run it. Metres, y up, the camera looks along -z.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <numbers>
#include <string>
#include <vector>

using glm::dvec3;

namespace {

constexpr double kPi = std::numbers::pi;

struct Point {
  dvec3 position;
  dvec3 normal;
};

// Equal lines are written once, so that surfaces share the vertices along their seams.
class ObjFile {
 public:
  explicit ObjFile(const char* path) : file_(path) { file_ << "mtllib default.mtl\n"; }

  void material(const char* name) { file_ << "usemtl " << name << "\n"; }
  void quad(const std::array<Point, 4>& corners);
  // Without normals: flat.
  void flatQuad(const std::array<dvec3, 4>& corners);
  bool close();

 private:
  using Lines = std::map<std::string, int>;
  int indexOf(Lines& lines, const char* keyword, const dvec3& v);

  std::ofstream file_;
  Lines positions_, normals_;
};

int ObjFile::indexOf(Lines& lines, const char* keyword, const dvec3& v) {
  char line[80];
  // Adding zero turns -0 into 0.
  const dvec3 r = glm::round(v * 1e4) * 1e-4 + 0.0;
  std::snprintf(line, sizeof line, "%s %.4g %.4g %.4g", keyword, r.x, r.y, r.z);
  const auto [place, is_new] = lines.emplace(line, static_cast<int>(lines.size()) + 1);
  if (is_new) file_ << line << "\n";
  return place->second;
}

void ObjFile::quad(const std::array<Point, 4>& corners) {
  std::string face = "f";
  for (const Point& corner : corners) {
    face += " " + std::to_string(indexOf(positions_, "v", corner.position));
    face += "//" + std::to_string(indexOf(normals_, "vn", corner.normal));
  }
  file_ << face << "\n";
}

void ObjFile::flatQuad(const std::array<dvec3, 4>& corners) {
  std::string face = "f";
  for (const dvec3& corner : corners)
    face += " " + std::to_string(indexOf(positions_, "v", corner));
  file_ << face << "\n";
}

bool ObjFile::close() {
  file_.close();
  return !file_.fail();
}

// A grid of quads over (i, j) in [0, columns] x [0, rows], counter-clockwise where j is to the left
// of i, seen from outside.
void addGrid(ObjFile& obj, int columns, int rows, const std::function<Point(int, int)>& at) {
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      obj.quad({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

// Where an object stands: turned about y, then moved.
struct Place {
  dvec3 at{0};
  double turn = 0;  // degrees

  dvec3 direction(const dvec3& v) const {
    const double s = std::sin(glm::radians(turn)), c = std::cos(glm::radians(turn));
    return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
  }
  Point operator()(const Point& p) const {
    return {at + direction(p.position), direction(p.normal)};
  }
};

// --- Box with rounded edges; a sphere where the radius is half the size ------------------------

// Coordinates along one axis: a fan of `segments` over each edge, one flat piece between.
std::vector<double> roundedSteps(double flat_half, double radius, int segments) {
  std::vector<double> steps;
  for (int k = -segments; k <= 0; ++k) {
    steps.push_back(-flat_half + radius * std::tan(0.25 * kPi * k / segments));
  }
  for (int k = flat_half > 0 ? 0 : 1; k <= segments; ++k) {
    steps.push_back(flat_half + radius * std::tan(0.25 * kPi * k / segments));
  }
  return steps;
}

void addRoundedBox(ObjFile& obj, const dvec3& size, double radius, int segments,
                   const Place& place) {
  const dvec3 flat_half = 0.5 * size - radius;
  for (int face = 0; face < 6; ++face) {
    const int axis = face % 3, u_axis = (axis + 1) % 3, v_axis = (axis + 2) % 3;
    const double side = face < 3 ? 1 : -1;
    const auto u = roundedSteps(flat_half[u_axis], radius, segments);
    const auto v = roundedSteps(flat_half[v_axis], radius, segments);
    const int columns = static_cast<int>(u.size()) - 1;
    addGrid(obj, columns, static_cast<int>(v.size()) - 1, [&](int i, int j) {
      dvec3 on_box;
      on_box[axis] = side * 0.5 * size[axis];
      on_box[u_axis] = side * u[i];  // mirrored on the far face, which keeps the winding outward
      on_box[v_axis] = v[j];
      const dvec3 core = glm::clamp(on_box, -flat_half, flat_half);
      const dvec3 normal = glm::normalize(on_box - core);
      return place({core + radius * normal, normal});
    });
  }
}

void addSphere(ObjFile& obj, double radius, int segments, const Place& place) {
  addRoundedBox(obj, dvec3(2 * radius), radius, segments, place);
}

// --- Torus knot ----------------------------------------------------------------------------------

constexpr double kKnotRing = 0.56, kKnotWave = 0.30, kKnotTube = 0.165;

// The trefoil that winds twice around a torus's axis (z) and three times through its hole, with
// one lobe up; `t` in [0, 2 pi).
dvec3 knotCurve(double t, dvec3& torus_normal) {
  const double around = 2 * t + 0.5 * kPi;
  const dvec3 outward{std::cos(around), std::sin(around), 0};
  torus_normal = std::cos(3 * t) * outward + dvec3(0, 0, std::sin(3 * t));
  return kKnotRing * outward + kKnotWave * torus_normal;
}

Point knotPoint(double t, double angle) {
  constexpr double kStep = 1e-4;
  dvec3 normal, ignored;
  const dvec3 center = knotCurve(t, normal);
  const dvec3 along = glm::normalize(knotCurve(t + kStep, ignored) - knotCurve(t - kStep, ignored));
  const dvec3 side = glm::normalize(glm::cross(normal, along));
  const dvec3 out = std::cos(angle) * normal + std::sin(angle) * side;
  return {center + kKnotTube * out, out};
}

void addKnot(ObjFile& obj, int along, int around, const Place& place) {
  addGrid(obj, along, around, [&](int i, int j) {
    const double t = 2 * kPi * (i % along) / along;
    return place(knotPoint(t, 2 * kPi * (j % around) / around));
  });
}

double knotDepth() {
  double lowest = 0;
  for (int i = 0; i < 2000; ++i) {
    for (int j = 0; j < 60; ++j) {
      lowest = std::min(lowest, knotPoint(2 * kPi * i / 2000, 2 * kPi * j / 60).position.y);
    }
  }
  return -lowest;
}

// --- Backdrop and lights
// ---------------------------------------------------------------------------

// Floor, a quarter of a cylinder, wall.
void addBackdrop(ObjFile& obj) {
  constexpr double kHalfWidth = 9, kFront = 9, kBend = -1.6, kRadius = 2.2, kTop = 7;
  constexpr int kSegments = 20;
  std::vector<Point> profile{{{0, 0, kFront}, {0, 1, 0}}};
  for (int k = 0; k <= kSegments; ++k) {
    const double angle = 0.5 * kPi * k / kSegments;
    const dvec3 normal{0, std::cos(angle), std::sin(angle)};
    profile.push_back({dvec3(0, kRadius, kBend) - kRadius * normal, normal});
  }
  profile.push_back({{0, kTop, kBend - kRadius}, {0, 0, 1}});
  addGrid(obj, 1, static_cast<int>(profile.size()) - 1, [&](int i, int j) {
    Point p = profile[j];
    p.position.x = i == 0 ? -kHalfWidth : kHalfWidth;
    return p;
  });
}

// A rectangle at `at` whose front looks at `target`.
void addPanel(ObjFile& obj, const dvec3& at, const dvec3& target, double width, double height) {
  const dvec3 forward = glm::normalize(target - at);
  const dvec3 right = glm::normalize(glm::cross(dvec3(0, 1, 0), forward)) * (0.5 * width);
  const dvec3 up = glm::normalize(glm::cross(forward, right)) * (0.5 * height);
  obj.flatQuad({at - right - up, at + right - up, at + right + up, at - right + up});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_default FILE.obj\n", stderr);
    return 2;
  }
  ObjFile obj(argv[1]);
  obj.material("backdrop");
  addBackdrop(obj);

  constexpr double kPlinth = 0.34;
  obj.material("plinth");
  addRoundedBox(obj, {1.5, kPlinth, 1.1}, 0.04, 2, {{0.1, 0.5 * kPlinth, -0.35}, 8});
  obj.material("knot");
  addKnot(obj, 136, 14, {{0.1, kPlinth + knotDepth(), -0.35}, 22});
  obj.material("cube");
  addRoundedBox(obj, dvec3(0.72), 0.07, 3, {{-1.12, 0.36, 0.3}, 32});
  obj.material("ball");
  addSphere(obj, 0.4, 5, {{1.2, 0.4, 0.34}, 0});
  obj.material("bead");
  addSphere(obj, 0.17, 3, {{0.42, 0.17, 0.95}, 0});

  obj.material("key_light");
  addPanel(obj, {-3.6, 4.0, 2.2}, {0, 0.6, 0}, 1.4, 1.4);
  obj.material("fill_light");
  addPanel(obj, {4.6, 2.6, 3.4}, {0, 0.6, 0}, 2.4, 2.4);
  return obj.close() ? 0 : 1;
}
