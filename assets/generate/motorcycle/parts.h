// The motorcycle's parts. It stands on y = 0, +x is forward, +z is the rider's right.
#pragma once

#include "assets/generate/model/model.h"

namespace glimt::assets::motorcycle {

// --- Measures that parts share, in metres

inline constexpr double kWheelRadius = 0.32;  // over the tread
inline const dvec3 kFrontAxle{0.72, kWheelRadius, 0};
inline const dvec3 kRearAxle{-0.72, kWheelRadius, 0};
inline const dvec3 kPivot{-0.22, 0.40, 0};  // of the swing arm

inline constexpr double kRake = 25.5;       // degrees that the fork leans back
inline constexpr double kForkSpread = 0.1;  // of a leg from the middle
// A place along a fork leg, so far above the axle, and so far in front of the legs' plane.
dvec3 onFork(double above_axle, double forward, double z);
dvec3 forkDirection();

// --- Parts

void addWheels(Model& model);
void addBrakes(Model& model);
void addFork(Model& model);
void addFrame(Model& model);
void addSuspension(Model& model);
void addChain(Model& model);
void addEngine(Model& model);
void addIntake(Model& model);
void addExhaust(Model& model);
void addBodywork(Model& model);
void addSeat(Model& model);
void addMudguards(Model& model);
void addHandlebar(Model& model);
void addInstruments(Model& model);
void addLamps(Model& model);

// Materials, and the variants of paint and trim.
void addFinishes(Model& model);

void addStudio(Model& model);
void addShopFloor(Model& model);

}  // namespace glimt::assets::motorcycle
