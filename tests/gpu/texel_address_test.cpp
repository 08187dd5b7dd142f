// Element i of a data texture is found exactly, up to the largest textures that glimt makes.
#include <algorithm>
#include <catch2/catch.hpp>

#include "renderer/probes/address_probe.h"
#include "tests/gpu/contexts.h"

using namespace glimt;

namespace {

void checkSize(const test::TestContext& context, int power) {
  CAPTURE(context.name(), power);
  const AddressProbe probe = probeAddresses(context.device(), std::size_t{1} << power);
  CHECK(probe.elements == std::size_t{1} << std::min(power, 20));
  CHECK(probe.wrong == 0);
}

}  // namespace

TEST_CASE("every element of a data texture is found, in all sizes up to 2^20") {
  test::onEveryContext([](const test::TestContext& context) {
    for (int power = 0; power <= 20; ++power) checkSize(context, power);
  });
}

TEST_CASE("elements of the largest data textures are found") {
  test::onEveryContext([](const test::TestContext& context) {
    for (const int power : {22, 23}) checkSize(context, power);
  });
}
