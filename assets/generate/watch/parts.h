// The watch's parts. The dial lies in y = 0 and faces +y, 12 o'clock is at -z, 3 o'clock at +x.
#pragma once

#include "assets/generate/model/model.h"

namespace glimt::assets::watch {

inline constexpr double kMillimetre = 1e-3;
inline constexpr double kCaseRadius = 20.5 * kMillimetre;
inline constexpr double kDialRadius = 15.6 * kMillimetre;
inline constexpr double kBack = -6.6 * kMillimetre;      // of the case
inline constexpr double kStrapWidth = 20 * kMillimetre;  // at the lugs

// A place on the dial: so many minutes after 12, so far from the middle, so high.
dvec3 onDial(double minutes, double radius, double height);
// Turns what is made at 12 o'clock (towards -z) to a minute.
dmat4 atMinute(double minutes);

void addCase(Model& model);
void addBezel(Model& model);
void addDial(Model& model);
void addHands(Model& model);
void addStrap(Model& model);
void addCushion(Model& model);

// Materials, and the variants of metal, colour and fabric.
void addFinishes(Model& model);

// The table, and the soft boxes; the watch stands on y = 0.
void addTable(Model& model);

}  // namespace glimt::assets::watch
