#include <array>
#include <cmath>

#include "assets/generate/christmas/parts.h"
#include "assets/generate/geometry/random.h"
#include "assets/generate/geometry/solids.h"

namespace glimt::assets::christmas {
namespace {

// A ball that hangs from a twig: its hook is at the origin.
struct Hanging {
  Mesh ball, fittings;
};

Hanging bauble(double radius) {
  const double drop = radius + 0.016;
  Hanging made;
  made.ball = transformed(sphere(radius, 28), moved({0, -drop, 0}));
  made.fittings = transformed(lathe({{0.27 * radius, -0.02 * radius},
                                     {0.28 * radius, 0.20 * radius},
                                     {0.24 * radius, 0.24 * radius},
                                     {0, 0.25 * radius}},
                                    20),
                              moved({0, -drop + 0.93 * radius, 0}));
  append(made.fittings,
         transformed(torus(0.0034, 0.0006, 12, 4),
                     moved({0, -drop + 1.2 * radius + 0.003, 0}) * turned(90, {1, 0, 0})));
  append(made.fittings, tube({{0, -drop + 1.2 * radius + 0.005, 0}, {0, 0.004, 0}}, 0.0004, 5));
  return made;
}

// Turned like an icicle: a row of shrinking drops.
Hanging drop(double size) {
  Hanging made;
  const std::vector<dvec2> profile{{0, -3.6},     {0.05, -3.4},  {0.16, -2.6},  {0.22, -2.3},
                                   {0.18, -2.1},  {0.40, -1.75}, {0.72, -1.3},  {0.80, -1.0},
                                   {0.66, -0.62}, {0.30, -0.30}, {0.24, -0.15}, {0.20, 0}};
  std::vector<dvec2> scaled_profile;
  for (const dvec2& p : profile) scaled_profile.push_back(p * size + dvec2(0, -0.014));
  made.ball = lathe(scaled_profile, 32);
  made.fittings =
      transformed(cylinder(0.24 * size, 0, 0.35 * size, 0.001, 16), moved({0, -0.015, 0}));
  append(made.fittings, tube({{0, -0.012, 0}, {0, 0.004, 0}}, 0.0004, 5));
  return made;
}

constexpr std::array<const char*, 7> kFinishes{
    "red bauble",       "gold bauble",   "frosted bauble",    "glass bauble",
    "red satin bauble", "silver bauble", "amber glass bauble"};

}  // namespace

// On every few branches near its tip, where there is room below.
void addBaubles(Model& model, const Tree& tree) {
  Random random(7);
  Mesh fittings;
  std::array<Mesh, kFinishes.size()> balls;
  std::vector<dvec3> taken;
  std::size_t next = 0;
  for (const Branch& branch : tree.branches) {
    const double along = random.between(0.84, 1.0);
    const auto place =
        static_cast<std::size_t>(along * static_cast<double>(branch.line.size() - 1));
    const dvec3 at = branch.line[place] - dvec3(0, 0.018, 0);
    bool free = branch.height > 0.38 && branch.height < 1.74;
    for (const dvec3& other : taken) free = free && glm::length(other - at) > 0.128;
    if (!free) continue;
    taken.push_back(at);
    const double size =
        glm::mix(0.047, 0.026, branch.height / kTreeTop) * random.between(0.85, 1.15);
    const Hanging made = next % 6 == 5 ? drop(0.6 * size) : bauble(size);
    const dmat4 hook = treePlace() * moved(at);
    append(balls[next % kFinishes.size()], transformed(made.ball, hook));
    append(fittings, transformed(made.fittings, hook));
    ++next;
  }
  for (std::size_t k = 0; k < kFinishes.size(); ++k)
    model.add(kFinishes[k], kFinishes[k], balls[k], 60);
  model.add("bauble fittings", "gold trim", fittings);
}

}  // namespace glimt::assets::christmas
