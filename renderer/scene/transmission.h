// Which materials light goes through, and what becomes of it inside.
#pragma once

#include "renderer/scene/scene.h"

namespace glimt {

bool transmits(const Material& material);

// The absorption coefficient inside, per metre: of light that goes d metres, exp(-d * it) is left.
// Zero where light does not get in, or there is no inside.
Vec3 absorptionOf(const Material& material);

}  // namespace glimt
