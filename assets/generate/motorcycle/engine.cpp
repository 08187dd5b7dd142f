#include <cmath>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/hull.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

constexpr double kCaseHalf = 0.112;
constexpr double kBore = 0.068;  // of a cylinder's axis from the middle

// Where the cylinders stand on the crankcase, leaning forward.
dmat4 barrelPlace() {
  return moved({0.045, 0.455, 0}) * turned(-9, {0, 0, 1});
}

// A plate drawn in x, y lies down: its y becomes -z, its depth becomes y.
Mesh lying(const Mesh& mesh, double height) {
  return transformed(mesh, moved({0, height, 0}) * turned(-90, {1, 0, 0}));
}

// A fin round both cylinders, pinched between them.
Mesh fin(double half_length, double half_width, double thick) {
  std::vector<dvec2> outline = superellipse(half_length, half_width, 5, 96);
  for (dvec2& point : outline) {
    const double between = point.y / 0.020;
    point.x *= 1 - 0.16 * std::exp(-between * between);
  }
  return plate(outline, thick, 0.0012);
}

Mesh barrels() {
  constexpr int kFins = 10;
  Mesh mesh;
  for (const double z : {-kBore, kBore})
    append(mesh, transformed(cylinder(0.056, 0, 0.18, 0.002, 56), moved({0, 0, z})));
  append(mesh, transformed(roundedBox({0.085, 0.18, 0.20}, 0.01, 2), moved({0, 0.09, 0})));
  for (int k = 0; k < kFins; ++k)
    append(mesh, lying(fin(0.080, 0.142, 0.0042), 0.016 + 0.0148 * k));
  return mesh;
}

Mesh head() {
  Mesh mesh = transformed(roundedBox({0.105, 0.075, 0.25}, 0.012, 3), moved({0, 0.205, 0}));
  for (int k = 0; k < 4; ++k)
    append(mesh, lying(fin(0.087, 0.150 - 0.004 * k, 0.0045), 0.174 + 0.0148 * k));
  for (const double z : {-0.072, 0.072}) {  // stubs of the exhaust and the intake
    append(mesh, tube({{0.05, 0.206, z}, {0.102, 0.209, z}}, 0.030, 32));
    append(mesh, tube({{-0.05, 0.208, z}, {-0.098, 0.200, z}}, 0.024, 32));
  }
  return mesh;
}

// Over the valves: a long box along each side, with ribs and caps.
Mesh rockerCovers() {
  Mesh mesh;
  for (const double x : {-0.040, 0.040}) {
    append(mesh, transformed(roundedBox({0.066, 0.050, 0.236}, 0.020, 6), moved({x, 0.240, 0})));
    for (const double z : {-kBore, kBore})
      append(mesh, transformed(cylinder(0.022, 0.255, 0.272, 0.004, 40), moved({x, 0, z})));
  }
  return mesh;
}

void addBarrels(Model& model) {
  const dmat4 place = barrelPlace();
  model.add("cylinders", "engine", transformed(barrels(), place));
  model.add("cylinder head", "cast alloy", transformed(head(), place));
  model.add("rocker covers", "polished alloy", transformed(rockerCovers(), place));
  Mesh bolts;
  for (const double x : {-0.040, 0.040})
    for (const double z : {-0.108, 0.0, 0.108})
      append(bolts, transformed(boltHead(0.014), place * moved({x, 0.263, z})));
  model.add("rocker bolts", "chrome", bolts);
  model.add("push rod tube", "chrome",
            transformed(tube({{0.088, 0.0, 0}, {0.088, 0.19, 0}}, 0.011, 24), place));
  for (const double side : {1.0, -1.0}) {
    const dvec3 out = glm::normalize(dvec3(0.25, 0.30, side));
    const dmat4 plug = place * pointing({0.025, 0.205, side * 0.122}, out);
    model.add("spark plug", "ceramic", transformed(cylinder(0.008, 0, 0.055, 0.002, 20), plug));
    model.add(
        "plug cap", "black rubber",
        transformed(
            lathe({{0.0105, 0.036}, {0.012, 0.040}, {0.0115, 0.070}, {0.007, 0.080}, {0, 0.080}},
                  24),
            plug));
    const dvec3 end = dvec3(plug * glm::dvec4(0, 0.078, 0, 1));
    model.add("plug lead", "black rubber",
              tube(smoothPath({end,
                               end + 0.04 * out,
                               end + dvec3(-0.05, 0.06, -side * 0.03),
                               {0.0, 0.77, side * 0.05}},
                              10),
                   0.0035, 10));
  }
}

Mesh crankcase() {
  const Hull hull({{-0.275, 0.098, 0.500, 0.290, 4},
                   {-0.16, kCaseHalf, 0.500, 0.262, 5},
                   {-0.02, kCaseHalf, 0.476, 0.246, 6},
                   {0.12, kCaseHalf, 0.470, 0.246, 6},
                   {0.205, 0.100, 0.440, 0.275, 4}},
                  9);
  Mesh mesh = hull.mesh(64, 96);
  append(mesh, transformed(roundedBox({0.16, 0.05, 0.15}, 0.012, 3), moved({0.02, 0.243, 0})));
  append(mesh, transformed(roundedBox({0.17, 0.02, 0.25}, 0.006, 2), moved({0.045, 0.462, 0})));
  return mesh;
}

// Screws along an outline, a little inside it.
Mesh screwsAlong(const std::vector<dvec2>& outline, int every, const dvec2& middle, double z,
                 double size) {
  Mesh screws;
  for (std::size_t i = 0; i < outline.size(); i += every) {
    const dvec2 inside = outline[i] + 0.009 * glm::normalize(middle - outline[i]);
    const Mesh screw = lathe({{size, 0},
                              {size, 0.7 * size},
                              {0.8 * size, 0.9 * size},
                              {0.45 * size, 0.9 * size},
                              {0.45 * size, 0.4 * size},
                              {0, 0.4 * size}},
                             18);
    append(screws, transformed(screw, moved({inside, z}) * turned(90, {1, 0, 0})));
  }
  return screws;
}

// The cover of one side, made on the right; `polished` domes stand on it.
void addCover(Model& model, const std::string& name, double side, const dvec2& crank,
              double crank_radius, const dvec2& gear, double gear_radius) {
  const dmat4 place = moved({0, 0, side * (kCaseHalf - 0.002)}) * scaled({1, 1, side});
  const auto outline = beltOutline(crank, crank_radius, gear, gear_radius, 30);
  const dvec2 middle = 0.5 * (crank + gear);
  const auto add = [&](const std::string& part, const std::string& material, const Mesh& mesh) {
    model.add(name + " " + part, material, transformed(mesh, place));
  };
  add("cover base", "cast alloy",
      plate(beltOutline(crank, crank_radius + 0.006, gear, gear_radius + 0.006, 30), 0.010, 0.002));
  add("cover", "polished alloy",
      transformed(cover(outline, 0.026, 0.016, 8), moved({0, 0, 0.008})));
  add("cover screws", "chrome",
      screwsAlong(beltOutline(crank, crank_radius - 0.004, gear, gear_radius - 0.004, 30), 8,
                  middle, 0.030, 0.0052));
  const dmat4 on_crank = moved({crank, 0.030}) * turned(90, {1, 0, 0});
  add("cover dome", "polished alloy",
      transformed(lathe({{0.72 * crank_radius, 0},
                         {0.70 * crank_radius, 0.008},
                         {0.64 * crank_radius, 0.014},
                         {0.50 * crank_radius, 0.017},
                         {0.49 * crank_radius, 0.015},
                         {0.30 * crank_radius, 0.015},
                         {0.29 * crank_radius, 0.018},
                         {0.15 * crank_radius, 0.021},
                         {0, 0.0215}},
                        72),
                  on_crank));
  const dmat4 on_gear = moved({gear, 0.030}) * turned(90, {1, 0, 0});
  add("cover cap", "engine",
      transformed(lathe({{0.56 * gear_radius, 0},
                         {0.56 * gear_radius, 0.007},
                         {0.50 * gear_radius, 0.010},
                         {0.22 * gear_radius, 0.010},
                         {0.20 * gear_radius, 0.014},
                         {0, 0.014}},
                        56),
                  on_gear));
}

void addPedals(Model& model) {
  for (const double side : {1.0, -1.0}) {
    const dvec3 root(-0.205, 0.335, side * 0.12), tip(-0.215, 0.338, side * 0.255);
    model.add("foot peg hanger", "cast alloy",
              tube(bentPath({{-0.235, 0.40, side * 0.118},
                             {-0.215, 0.345, side * 0.13},
                             root + dvec3(0, 0, side * 0.03)},
                            0.03, 6),
                   0.011, 16));
    std::vector<dvec2> ribs{{0, 0}, {0.014, 0}};
    for (int k = 0; k < 8; ++k) {
      ribs.emplace_back(0.0165, 0.004 + 0.011 * k);
      ribs.emplace_back(0.0165, 0.011 + 0.011 * k);
      ribs.emplace_back(0.0140, 0.013 + 0.011 * k);
    }
    ribs.emplace_back(0.018, 0.094);
    ribs.emplace_back(0.018, 0.100);
    ribs.emplace_back(0, 0.100);
    model.add("foot peg", "black rubber",
              transformed(lathe(ribs, 28), pointing(root + dvec3(0, 0, side * 0.035), tip - root)));
    const dvec3 pedal(-0.045, 0.305, side * 0.175);
    model.add(
        "pedal", "chrome",
        tube(bentPath({root + dvec3(0.03, -0.03, side * 0.03), {-0.10, 0.295, side * 0.160}, pedal},
                      0.05, 8),
             0.0065, 16));
    model.add("pedal pad", "black rubber",
              transformed(cylinder(0.011, -0.028, 0.028, 0.003, 24),
                          moved(pedal) * turned(90, {1, 0, 0})));
  }
}

}  // namespace

void addEngine(Model& model) {
  model.add("crankcase", "engine", crankcase());
  addCover(model, "right", 1, {0.085, 0.365}, 0.098, {-0.14, 0.392}, 0.062);
  addCover(model, "left", -1, {0.075, 0.360}, 0.104, {-0.10, 0.395}, 0.070);
  addBarrels(model);
  model.add("oil filler", "black metal",
            transformed(
                lathe({{0.016, 0}, {0.018, 0.004}, {0.018, 0.012}, {0.014, 0.016}, {0, 0.016}}, 12),
                pointing({-0.07, 0.462, 0.085}, {0, 1, 0.4})));
  addPedals(model);
}

}  // namespace glimt::assets::motorcycle
