#include "renderer/scene/default_bounces.h"

#include <catch2/catch.hpp>

using namespace glimt;

TEST_CASE("mirrors and glass call for more bounces, and no other effect does") {
  const BounceLimit plain = defaultBounces({});
  CHECK(plain.bounces == 4);
  CHECK(plain.reason == "no surface is a mirror or glass");
  for (int i = 0; i < kEffectCount; ++i) {
    const auto effect = static_cast<Effect>(i);
    const BounceLimit limit = defaultBounces(EffectSet().set(static_cast<std::size_t>(i)));
    CAPTURE(nameOf(effect));
    const bool sends =
        effect == Effect::mirror || effect == Effect::glass || effect == Effect::rough_glass;
    CHECK(limit.bounces == (sends ? 8 : 4));
    if (sends) CHECK_THAT(limit.reason, Catch::EndsWith(": " + nameOf(effect)));
  }
  CHECK(defaultBounces(EffectSet().set()).bounces == 8);
}
