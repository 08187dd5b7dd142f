#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/generate/christmas/parts.h"
#include "assets/generate/geometry/grid.h"
#include "assets/generate/geometry/random.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/model/studio_set.h"

namespace glimt::assets::christmas {
namespace {

constexpr double kHalfWidth = 3.2, kFront = 3.6, kHeight = 2.75;

struct Rectangle {
  double left, right, bottom, top;
};
constexpr Rectangle kWindow{-1.86, -0.88, 0.86, 2.10};

// A board with sloping edges; the picture starts anywhere on it.
Mesh plank(double x, double width, double from, double to, Random& random) {
  constexpr double kEdge = 0.0035, kSlope = 0.0025, kTile = 1.4;
  const double u = random.next(), v = random.next();
  const double xs[] = {x, x + kEdge, x + width - kEdge, x + width};
  const double zs[] = {from, from - kEdge, to + kEdge, to};
  Mesh mesh = texturedGrid(3, 3, {1, 1}, [&](int i, int j) {
    const bool edge = i == 0 || i == 3 || j == 0 || j == 3;
    return dvec3(xs[i], edge ? -kSlope : 0, zs[j]);
  });
  for (std::size_t k = 0; k < mesh.positions.size(); ++k)
    mesh.texture_coordinates[k] =
        dvec2(u + mesh.positions[k].x / (0.5 * kTile), v + mesh.positions[k].z / kTile);
  return mesh;
}

Mesh box(const Rectangle& r, double back, double front, double round = 0.003) {
  return transformed(
      roundedBox({r.right - r.left, r.top - r.bottom, front - back}, round, 1),
      moved({0.5 * (r.left + r.right), 0.5 * (r.bottom + r.top), 0.5 * (back + front)}));
}

Mesh wallPiece(const Rectangle& r) {
  return grid(1, 1, Edges::open, Edges::open, [&](int i, int j) {
    return dvec3(i == 0 ? r.left : r.right, j == 0 ? r.bottom : r.top, kWall);
  });
}

// Four mitred strips round a rectangle, with a profile of two steps.
Mesh moulding(const Rectangle& r, double width, double height) {
  Mesh all;
  for (const double step : {0.0, 0.35}) {
    const double in = step * width, z = kWall + height * (1 - step);
    const double w = width * (1 - 1.5 * step);
    append(all,
           box({r.left + in, r.right - in, r.bottom + in, r.bottom + in + w}, kWall - 0.01, z));
    append(all, box({r.left + in, r.right - in, r.top - in - w, r.top - in}, kWall - 0.01, z));
    append(all, box({r.left + in, r.left + in + w, r.bottom + in, r.top - in}, kWall - 0.01, z));
    append(all, box({r.right - in - w, r.right - in, r.bottom + in, r.top - in}, kWall - 0.01, z));
  }
  return all;
}

// Cloth that hangs in folds, gathered at the top.
Mesh curtain(double left, double right, double bottom, double top) {
  constexpr int kAcross = 90, kDown = 24;
  return grid(kAcross, kDown, Edges::open, Edges::open, [&](int i, int j) {
    const double s = static_cast<double>(i) / kAcross, t = static_cast<double>(j) / kDown;
    const double wave = std::sin(2 * std::numbers::pi * 6.5 * s + 0.9 * std::sin(3 * t)) *
                        glm::mix(0.034, 0.020, t);
    return dvec3(glm::mix(left, right, s) + 0.008 * std::sin(9 * s + 2 * t),
                 glm::mix(bottom, top, t), kWall + 0.085 + wave);
  });
}

void addCurtains(Model& model) {
  const Rectangle& w = kWindow;
  model.add("curtains", "curtain",
            joined({curtain(w.left - 0.30, w.left + 0.10, 0.02, 2.28),
                    curtain(w.right - 0.10, w.right + 0.28, 0.02, 2.28)}),
            80);
  Mesh rod = tube({{w.left - 0.40, 2.31, kWall + 0.085}, {w.right + 0.38, 2.31, kWall + 0.085}},
                  0.012, 20);
  for (const double x : {w.left - 0.42, w.right + 0.40})
    append(rod, transformed(sphere(0.024, 24), moved({x, 2.31, kWall + 0.085})));
  model.add("curtain rod", "brass", rod);
}

// What is seen outside: snow below a sky, no larger than what the window shows, so that light is
// not sought where the wall hides it.
void addOutside(Model& model) {
  const double z = kWall - 0.75;
  const Rectangle seen{-2.35, -0.80, 0.60, 2.40};
  const double horizon = 1.22;
  const auto panel = [&](double bottom, double top) {
    return grid(1, 1, Edges::open, Edges::open, [&](int i, int j) {
      return dvec3(i == 0 ? seen.left : seen.right, j == 0 ? bottom : top, z);
    });
  };
  model.add("sky", "sky", panel(horizon, seen.top));
  model.add("evening glow", "evening glow", panel(horizon - 0.3, horizon));
  const Mesh hills = grid(60, 8, Edges::open, Edges::open, [&](int i, int j) {
    const double x = glm::mix(seen.left, seen.right, i / 60.0);
    const double crest = 1.06 + 0.045 * std::sin(4.1 * x + 0.4) + 0.015 * std::sin(11.3 * x);
    return dvec3(x, glm::mix(seen.bottom, crest, j / 8.0), z + 0.3 - 0.25 * j / 8.0);
  });
  model.add("snow hills", "snow", hills, 80);
  Mesh firs;
  for (int k = 0; k < 8; ++k) {
    const double size = 0.13 + 0.05 * std::sin(2.3 * k);
    const dvec3 foot(-2.26 + 0.205 * k + 0.05 * std::sin(5.0 * k), 1.03, z + 0.06);
    for (int tier = 0; tier < 4; ++tier)
      append(firs,
             transformed(lathe({{size * (0.42 - 0.085 * tier), 0}, {0.02 * size, size * 0.62}}, 14),
                         moved(foot + dvec3(0, size * 0.36 * tier, 0))));
  }
  model.add("firs outside", "dark fir", firs);
}

}  // namespace

void addFloor(Model& model) {
  constexpr double kPlankWidth = 0.145;
  Random random(5);
  Mesh woods[3];
  for (double x = -kHalfWidth; x < kHalfWidth; x += kPlankWidth)
    for (double z = kFront + random.between(0, 1.5); z > kWall;) {
      const double to = z - random.between(1.3, 2.1);
      append(woods[static_cast<int>(3 * random.next())],
             plank(x, kPlankWidth, std::min(z, kFront), std::max(to, kWall), random));
      z = to;
    }
  const char* const names[] = {"light planks", "planks", "dark planks"};
  for (int k = 0; k < 3; ++k) model.add(names[k], names[k], woods[k]);
  const Mesh rug = lathe({{1.02, 0}, {1.025, 0.003}, {1.02, 0.006}, {0, 0.006}}, 128);
  model.add("rug", "rug", transformed(rug, treePlace() * moved({0, 0, 0.30})));
  for (const double r : {0.90, 0.955})
    model.add("rug stripe", "rug stripe",
              transformed(ring(r, r + 0.022, 0.004, 0.0066, 0.0006, 128),
                          treePlace() * moved({0, 0, 0.30})));
}

void addWalls(Model& model) {
  const Rectangle& w = kWindow;
  Mesh wall = wallPiece({-kHalfWidth, w.left, 0, kHeight});
  append(wall, wallPiece({w.right, kHalfWidth, 0, kHeight}));
  append(wall, wallPiece({w.left, w.right, 0, w.bottom}));
  append(wall, wallPiece({w.left, w.right, w.top, kHeight}));
  model.add("wall", "wall paint", wall);
  Mesh panelling = box({-kHalfWidth, kHalfWidth, 0, 0.14}, kWall - 0.01, kWall + 0.018);
  append(panelling, box({-kHalfWidth, kHalfWidth, 0.75, 0.79}, kWall - 0.01, kWall + 0.028));
  for (double x = -2.9; x < 3.0; x += 0.72)
    append(panelling, moulding({x, x + 0.60, 0.22, 0.67}, 0.032, 0.016));
  model.add("panelling", "white paint", panelling);
  // A picture in a gilded frame.
  const Rectangle frame{1.02, 1.62, 1.12, 1.92};
  model.add("picture frame", "gold trim", moulding(frame, 0.07, 0.04));
  model.add("picture mount", "white paint",
            box({frame.left + 0.06, frame.right - 0.06, frame.bottom + 0.06, frame.top - 0.06},
                kWall, kWall + 0.008));
  model.add("picture", "picture",
            box({frame.left + 0.15, frame.right - 0.15, frame.bottom + 0.18, frame.top - 0.15},
                kWall, kWall + 0.010));
}

void addWindow(Model& model) {
  const Rectangle& w = kWindow;
  Mesh frame =
      moulding({w.left - 0.075, w.right + 0.075, w.bottom - 0.02, w.top + 0.075}, 0.075, 0.024);
  const double depth = 0.14;
  for (const auto& [left, right, bottom, top] :
       {Rectangle{w.left - 0.01, w.left + 0.035, w.bottom, w.top},
        Rectangle{w.right - 0.035, w.right + 0.01, w.bottom, w.top},
        Rectangle{w.left, w.right, w.top - 0.035, w.top + 0.01},
        Rectangle{w.left, w.right, w.bottom - 0.01, w.bottom + 0.035}})
    append(frame, box({left, right, bottom, top}, kWall - depth, kWall + 0.004));
  const double middle = 0.5 * (w.left + w.right);
  append(frame, box({middle - 0.022, middle + 0.022, w.bottom, w.top}, kWall - 0.10, kWall - 0.05));
  for (const double t : {0.36, 0.68}) {
    const double y = glm::mix(w.bottom, w.top, t);
    append(frame, box({w.left, w.right, y - 0.014, y + 0.014}, kWall - 0.09, kWall - 0.06));
  }
  append(frame, box({w.left - 0.12, w.right + 0.12, w.bottom - 0.035, w.bottom + 0.005},
                    kWall - depth, kWall + 0.07, 0.008));
  model.add("window frame", "white paint", frame);
  addCurtains(model);
  addOutside(model);
}

void addLight(Model& model) {
  // A lamp's large shade beside the viewer, and the light of a fire from the other side.
  addSoftBox(model, "lamp light", {27.0, 19.0, 11.8},
             softBox({2.5, 2.5, 2.6}, {0.1, 0.9, 0}, 1.1, 1.1));
  addSoftBox(model, "fire light", {9.0, 4.4, 1.9},
             softBox({-2.9, 0.8, 2.6}, {0, 0.6, 0}, 0.9, 0.8));
}

}  // namespace glimt::assets::christmas
