#include "app/viewer/reloaded_look.h"

#include <catch2/catch.hpp>

using namespace glimt;

TEST_CASE("when the file changes, what was changed by hand stays and all else follows the file") {
  Look before;
  before.materials.resize(2);
  Look look = before;
  look.exposure = 2;
  look.materials[1].roughness = 0.25f;
  Look now = before;
  now.exposure = -1;
  now.environment_strength = 3;
  now.bounces = 8;
  now.materials[0].metallic = 1;
  now.materials[1].roughness = 0.75f;
  const Look result = reloadedLook(look, before, now);
  CHECK(result.exposure == 2);
  CHECK(result.environment_strength == 3);
  CHECK(result.bounces == 8);
  CHECK(result.materials[0].metallic == 1);
  CHECK(result.materials[1].roughness == 0.25f);
}

TEST_CASE("a file with other materials takes their changes away") {
  Look before;
  before.materials.resize(2);
  Look look = before;
  look.materials[0].roughness = 0.25f;
  Look now = before;
  now.materials.resize(3);
  CHECK(reloadedLook(look, before, now).materials == now.materials);
}
