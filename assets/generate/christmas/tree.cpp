#include <cmath>

#include "assets/generate/christmas/parts.h"
#include "assets/generate/geometry/random.h"
#include "assets/generate/geometry/solids.h"

namespace glimt::assets::christmas {
namespace {

constexpr double kLowest = 0.34;  // branches
constexpr double kNeedleLength = 0.025, kNeedleWidth = 0.0036;
constexpr double kNeedleSpacing = 0.0026;  // along a twig

dvec3 anyUpright(const dvec3& direction) {
  const dvec3 side = std::abs(direction.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  return glm::normalize(glm::cross(direction, side));
}

// A leaf of two triangles, a little folded along its middle.
void addNeedle(Mesh& mesh, const dvec3& root, const dvec3& direction, const dvec3& side,
               double length) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const dvec3 across = side * (0.5 * kNeedleWidth);
  mesh.positions.insert(mesh.positions.end(),
                        {root, root + 0.45 * length * direction + across, root + length * direction,
                         root + 0.45 * length * direction - across});
  mesh.triangles.push_back(uvec3(0, 1, 2) + first);
  mesh.triangles.push_back(uvec3(0, 2, 3) + first);
}

// Needles all round a twig, leaning forward; fewer below.
void addNeedles(Mesh& mesh, const dvec3& from, const dvec3& to, Random& random) {
  const dvec3 along = glm::normalize(to - from);
  const dvec3 side = anyUpright(along), up = glm::cross(side, along);
  const int count = static_cast<int>(glm::length(to - from) / kNeedleSpacing);
  for (int k = 0; k < count; ++k) {
    // From -110 to 290 degrees about the twig, 0 is to the side: the gap is below.
    const double around = glm::radians(random.between(-75, 255));
    const double lean = glm::radians(random.between(38, 66));
    const dvec3 out = std::cos(around) * side + std::sin(around) * up;
    const dvec3 direction = glm::normalize(std::cos(lean) * along + std::sin(lean) * out);
    const dvec3 root = glm::mix(from, to, (k + random.next()) / count);
    const dvec3 flat = glm::normalize(glm::cross(direction, out));
    const dvec3 roll = glm::normalize(flat + random.between(-0.5, 0.5) * out);
    addNeedle(mesh, root, direction, roll, kNeedleLength * random.between(0.75, 1.1));
  }
}

class Grower {
 public:
  Tree grow();

 private:
  void growBranch(double height, double turn, double length, double rise);
  void growTwigs(const Path& line, double length);
  void growTwig(const dvec3& from, const dvec3& direction, double length);

  Tree tree_;
  Random random_{20131224};
};

Tree Grower::grow() {
  Path trunk;
  for (int k = 0; k <= 24; ++k)
    trunk.emplace_back(0.004 * std::sin(0.7 * k), 0.02 + 1.90 * k / 24, 0.004 * std::cos(0.9 * k));
  tree_.wood = sweep(
      trunk, circle(0.036, 16), {1, 0, 0}, [](double t) { return 1 - 0.9 * t; }, true);
  double turn = 0;
  // From below upwards, each branch turned by the golden angle from the one before.
  for (double height = kLowest; height < 1.87;) {
    const double t = (height - kLowest) / (kTreeTop - kLowest);
    growBranch(height, turn, reachAt(height) * random_.between(0.84, 1.08),
               glm::mix(-0.06, 0.75, t * t));
    turn += 137.508;
    height += glm::mix(0.0088, 0.020, t);
  }
  growTwig({0, 1.80, 0}, {0, 1, 0}, 0.16);
  return tree_;
}

void Grower::growBranch(double height, double turn, double length, double rise) {
  const double angle = glm::radians(turn + random_.between(-8, 8));
  const dvec3 out(std::cos(angle), 0, std::sin(angle));
  const double sag = 0.16 * length, lift = rise + random_.between(-0.06, 0.06);
  Path controls;
  for (const double t : {0.0, 0.35, 0.7, 1.0}) {
    // Down by its weight, and up again at the tip.
    const double bend = -sag * std::sin(2.2 * t) + 0.10 * length * t * t;
    controls.push_back(dvec3(0, height, 0) + length * t * out +
                       dvec3(0, lift * length * t + bend, 0));
  }
  const Path line = smoothPath(controls, 5);
  append(tree_.wood, sweep(
                         line, circle(0.004 + 0.008 * length, 6), {0, 1, 0},
                         [](double t) { return 1 - 0.85 * t; }, false));
  growTwigs(line, length);
  tree_.branches.push_back({line, height});
}

void Grower::growTwigs(const Path& line, double length) {
  const std::size_t last = line.size() - 1;
  for (std::size_t i = 3; i < last; ++i) addNeedles(tree_.needles, line[i], line[i + 1], random_);
  const int pairs = static_cast<int>(length / 0.050);
  for (int k = 1; k <= pairs; ++k) {
    const double t = glm::mix(0.22, 0.97, static_cast<double>(k) / (pairs + 1));
    const auto i = static_cast<std::size_t>(t * static_cast<double>(last));
    const dvec3 from =
        glm::mix(line[i], line[i + 1], t * static_cast<double>(last) - static_cast<double>(i));
    const dvec3 along = glm::normalize(line[i + 1] - line[i]);
    const dvec3 side = glm::normalize(glm::cross(along, dvec3(0, 1, 0)));
    for (const double sign : {1.0, -1.0}) {
      const dvec3 direction = glm::normalize(along * random_.between(0.75, 1.05) + sign * side +
                                             dvec3(0, random_.between(-0.16, 0.12), 0));
      growTwig(from, direction, (0.05 + 0.30 * length * (1.05 - t)) * random_.between(0.75, 1.15));
    }
  }
}

void Grower::growTwig(const dvec3& from, const dvec3& direction, double length) {
  const dvec3 middle = from + 0.5 * length * direction;
  const dvec3 to = from + length * direction + dvec3(0, -0.07 * length, 0);
  append(tree_.wood, tube({from, middle, to}, 0.0013, 4));
  addNeedles(tree_.needles, from, middle, random_);
  addNeedles(tree_.needles, middle, to + 0.012 * direction, random_);
}

}  // namespace

double reachAt(double height) {
  const double t = (kTreeTop - height) / (kTreeTop - kLowest);
  return 0.045 + 0.66 * std::pow(std::max(t, 0.0), 0.88);
}

dmat4 treePlace() {
  return moved({0.12, 0.0, -0.15});
}

Tree growTree() {
  return Grower().grow();
}

void addTree(Model& model, const Tree& tree) {
  model.add("needles", "needles", transformed(tree.needles, treePlace()), 1);
  model.add("wood", "bark", transformed(tree.wood, treePlace()));
  const Mesh pot = lathe({{0, 0.0},
                          {0.135, 0.0},
                          {0.142, 0.006},
                          {0.165, 0.21},
                          {0.172, 0.215},
                          {0.176, 0.224},
                          {0.172, 0.233},
                          {0.164, 0.234},
                          {0.158, 0.225},
                          {0.155, 0.20}},
                         80);
  model.add("pot", "copper", transformed(pot, treePlace()));
  model.add("soil", "bark",
            transformed(lathe({{0.156, 0.20}, {0.10, 0.212}, {0, 0.216}}, 32), treePlace()));
  for (const double y : {0.062, 0.165})
    model.add(
        "pot hoop", "copper",
        transformed(torus(0.1425 + 0.108 * y, 0.0035, 80, 10), treePlace() * moved({0, y, 0})));
}

}  // namespace glimt::assets::christmas
