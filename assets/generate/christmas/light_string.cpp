#include <cmath>

#include "assets/generate/christmas/parts.h"
#include "assets/generate/geometry/random.h"
#include "assets/generate/geometry/solids.h"

namespace glimt::assets::christmas {
namespace {

constexpr double kBulbSpacing = 0.105;

// Wound round the tree from below, looser where it sags between branches.
Path winding() {
  constexpr int kTurns = 9, kSteps = 34;
  Random random(3);
  Path controls;
  for (int k = 0; k <= kTurns * kSteps; ++k) {
    const double t = static_cast<double>(k) / (kTurns * kSteps);
    const double angle = glm::radians(360.0 * k / kSteps);
    const double height = glm::mix(0.36, 1.84, std::pow(t, 0.85)) + random.between(-0.014, 0.010);
    const double radius = reachAt(height) * random.between(0.88, 0.97) - 0.005;
    // Branches hang: what is far out on them is lower.
    controls.emplace_back(radius * std::cos(angle), height - 0.03 * radius,
                          radius * std::sin(angle));
  }
  return smoothPath(controls, 3);
}

Mesh bulb() {
  return lathe({{0.0028, 0},
                {0.0030, 0.002},
                {0.0046, 0.006},
                {0.0047, 0.011},
                {0.0030, 0.0155},
                {0, 0.017}},
               8);
}

}  // namespace

void addLightString(Model& model) {
  const Path line = winding();
  model.add("light string", "cable", transformed(tube(line, 0.0011, 5), treePlace()));
  Random random(11);
  Mesh bulbs, sockets;
  double passed = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    passed += glm::length(line[i] - line[i - 1]);
    if (passed < kBulbSpacing) continue;
    passed = 0;
    const dvec3 out = glm::normalize(dvec3(line[i].x, 0, line[i].z));
    const dvec3 direction =
        glm::normalize(out + dvec3(random.between(-0.5, 0.5), random.between(0.1, 1.0),
                                   random.between(-0.5, 0.5)));
    const dmat4 place = treePlace() * pointing(line[i], direction);
    append(bulbs, transformed(bulb(), place * moved({0, 0.010, 0})));
    append(sockets,
           transformed(lathe({{0, 0}, {0.0030, 0}, {0.0033, 0.010}, {0.0026, 0.011}}, 8), place));
  }
  model.add("bulbs", "bulb", bulbs, 60);
  model.add("sockets", "cable", sockets);
}

void addStar(Model& model) {
  constexpr int kPoints = 5;
  std::vector<dvec2> outline;
  for (int k = 0; k < 2 * kPoints; ++k) {
    const double angle = glm::radians(90.0 + 180.0 * k / kPoints), r = k % 2 == 0 ? 0.105 : 0.042;
    outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  Mesh star;  // a ridge from the middle to each point, on both sides
  for (const dvec2& p : outline) star.positions.emplace_back(p, 0);
  star.positions.emplace_back(0, 0, 0.026);
  star.positions.emplace_back(0, 0, -0.026);
  const std::uint32_t count = 2 * kPoints;
  for (std::uint32_t i = 0; i < count; ++i) {
    star.triangles.emplace_back(i, (i + 1) % count, count);
    star.triangles.emplace_back((i + 1) % count, i, count + 1);
  }
  const dmat4 top = treePlace() * moved({0, kTreeTop + 0.075, 0}) * turned(8, {0, 1, 0});
  model.add("star", "star", transformed(star, top), 5);
  model.add(
      "star holder", "gold trim",
      transformed(lathe({{0.020, -0.17}, {0.012, -0.11}, {0.006, -0.03}, {0, -0.03}}, 24), top));
}

}  // namespace glimt::assets::christmas
