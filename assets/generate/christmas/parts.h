// The room's parts. The floor is y = 0, the wall behind is at z = kWall, the customer is at +z.
#pragma once

#include <vector>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/model/model.h"

namespace glimt::assets::christmas {

inline constexpr double kWall = -1.15;

// --- The tree stands on the floor at its own origin

inline constexpr double kTreeTop = 1.98;

// How far branches reach at a height.
double reachAt(double height);

struct Branch {
  Path line;  // from the trunk outwards
  double height;
};

struct Tree {
  std::vector<Branch> branches;
  Mesh wood;
  Mesh needles;
};

Tree growTree();

// --- Parts

void addTree(Model& model, const Tree& tree);
void addBaubles(Model& model, const Tree& tree);
void addLightString(Model& model);
void addStar(Model& model);
void addParcels(Model& model);
void addLanterns(Model& model);
void addFloor(Model& model);
void addWalls(Model& model);
void addWindow(Model& model);
void addLight(Model& model);

void addFinishes(Model& model);

// Where the tree stands.
dmat4 treePlace();

}  // namespace glimt::assets::christmas
