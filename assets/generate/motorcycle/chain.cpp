#include <cmath>
#include <numbers>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kZ = -0.075;
constexpr double kPitch = 0.0158;
const dvec3 kFrontSprocket{-0.13, 0.405, kZ};
constexpr double kFrontRadius = 0.042, kRearRadius = 0.105;

// Sprocket: a toothed disc with a rounded tooth every `kPitch`.
Mesh sprocket(double radius) {
  const int teeth = static_cast<int>(std::round(2 * kPi * radius / kPitch));
  std::vector<dvec2> outline;
  for (int k = 0; k < teeth * 6; ++k) {
    const double angle = 2 * kPi * k / (teeth * 6);
    const double r = radius + 0.004 * std::cos(teeth * angle);
    outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return transformed(plate(outline, 0.006, 0.0008), moved({0, 0, -0.003}));
}

// Once round both sprockets, along the chain's middle.
Path chainLine() {
  const dvec3 apart = kRearAxle + dvec3(0, 0, kZ) - kFrontSprocket;
  const double distance = glm::length(apart);
  const dvec3 back = apart / distance, up(-back.y, back.x, 0);
  const double lean = glm::degrees(std::asin((kRearRadius - kFrontRadius) / distance));
  const dvec3 above = up.y > 0 ? up : -up;
  Path line = arcPath(kFrontSprocket, kFrontRadius * -back, kFrontRadius * above, -90 - lean,
                      90 + lean, 24);
  const Path rear = arcPath(kRearAxle + dvec3(0, 0, kZ), kRearRadius * back, kRearRadius * above,
                            90 - lean, -90 + lean, 40);
  line.insert(line.end(), rear.begin(), rear.end());
  line.push_back(line.front());
  return line;
}

// A point every `step` along a line.
Path spaced(const Path& line, int count) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += glm::length(line[i] - line[i - 1]);
  Path points;
  double next = 0, passed = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double piece = glm::length(line[i] - line[i - 1]);
    for (; next < passed + piece && static_cast<int>(points.size()) < count; next += length / count)
      points.push_back(glm::mix(line[i - 1], line[i], (next - passed) / piece));
    passed += piece;
  }
  return points;
}

// An outer or an inner pair of plates, along +x.
Mesh link(double pitch, bool outer) {
  std::vector<dvec2> outline;
  for (int k = 0; k < 12; ++k) {
    const double a = 2 * kPi * k / 12, c = std::cos(a);
    outline.emplace_back(0.5 * pitch * (c > 0 ? 1 : -1) + 0.0062 * c,
                         0.0062 * std::sin(a) * (std::abs(c) < 0.35 ? 0.8 : 1));
  }
  const Mesh side = plate(outline, 0.0016, 0.0003);
  const double z = outer ? 0.0075 : 0.0055;
  Mesh both = transformed(side, moved({0, 0, z}));
  append(both, transformed(side, moved({0, 0, -z - 0.0016})));
  const Mesh pin = transformed(cylinder(0.0042, -0.0085, 0.0085, 0.0006, 8),
                               moved({0.5 * pitch, 0, 0}) * turned(90, {1, 0, 0}));
  append(both, pin);
  return both;
}

}  // namespace

void addChain(Model& model) {
  const Path line = chainLine();
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += glm::length(line[i] - line[i - 1]);
  const int count = 2 * static_cast<int>(std::round(0.5 * length / kPitch));
  const Path points = spaced(line, count);
  Mesh chain;
  for (int i = 0; i < count; ++i) {
    const dvec3 a = points[i], b = points[(i + 1) % count];
    const double angle = glm::degrees(std::atan2(b.y - a.y, b.x - a.x));
    append(chain, transformed(link(glm::length(b - a), i % 2 == 0),
                              moved(0.5 * (a + b)) * turned(angle, {0, 0, 1})));
  }
  model.add("chain", "steel", chain);
  Mesh sprockets = transformed(sprocket(kRearRadius), moved(kRearAxle + dvec3(0, 0, kZ)));
  append(sprockets, transformed(sprocket(kFrontRadius), moved(kFrontSprocket)));
  model.add("sprockets", "disc steel", sprockets);
  const Path guard = bentPath(
      {{-0.28, 0.475, kZ - 0.004}, {-0.60, 0.45, kZ - 0.004}, {-0.80, 0.425, kZ - 0.004}}, 0.3, 8);
  model.add("chain guard", "frame",
            sweep(
                guard,
                {{-0.019, -0.028},
                 {-0.016, -0.028},
                 {-0.016, -0.003},
                 {0.016, -0.003},
                 {0.016, -0.010},
                 {0.019, -0.010},
                 {0.019, 0},
                 {-0.019, 0}},
                {0, 1, 0}, [](double) { return 1.0; }, true));
}

}  // namespace glimt::assets::motorcycle
