// The hit record packed and unpacked by the device is the one that C++ packs and unpacks.
#include <algorithm>
#include <catch2/catch.hpp>

#include "renderer/probes/record_probes.h"
#include "tests/gpu/contexts.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;
using glsl_float::HitRecord;

namespace {

constexpr std::size_t kCount = 60000;

std::vector<HitRecord> randomRecords() {
  test::Random random(32);
  std::vector<HitRecord> records;
  for (std::size_t i = 0; i < kCount; ++i) {
    float triangle = static_cast<float>(random.below(1u << 23));
    if (i % 100 == 0) triangle = glsl_float::TRIANGLE_NONE;
    if (i % 100 == 1) triangle = glsl_float::TRIANGLE_UNKNOWN;
    const Vec3 throughput =
        i % 50 == 0 ? Vec3(1) : random.logUniform(1e-13f, 1e6f) * glm::abs(random.cube());
    records.emplace_back(triangle, static_cast<float>(random.below(2)), random.weights(),
                         random.direction(), throughput,
                         i % 4 ? random.uniform() : static_cast<float>(i % 8 / 4));
  }
  return records;
}

std::vector<RecordValues> valuesOf(const std::vector<HitRecord>& records) {
  std::vector<RecordValues> values;
  for (const HitRecord& r : records)
    values.push_back({r.triangle, r.back, r.uv, r.direction, r.throughput, r.weight});
  return values;
}

std::vector<Vec4> randomRoundings() {
  test::Random random(33);
  std::vector<Vec4> roundings;
  for (std::size_t i = 0; i < kCount; ++i) roundings.push_back(random.four());
  return roundings;
}

std::vector<Vec4> encodeInCpp(const std::vector<HitRecord>& records,
                              const std::vector<Vec4>& random) {
  std::vector<Vec4> texels;
  for (std::size_t i = 0; i < records.size(); ++i)
    texels.push_back(glsl_float::encodeHitRecord(records[i], random[i]));
  return texels;
}

}  // namespace

TEST_CASE("the device encodes hit records as C++ does") {
  const std::vector<HitRecord> records = randomRecords();
  const std::vector<Vec4> roundings = randomRoundings();
  const std::vector<Vec4> expected = encodeInCpp(records, roundings);
  test::onEveryContext([&](const test::TestContext& context) {
    CAPTURE(context.name());
    const std::vector<Vec4> texels = encodeRecords(context.device(), valuesOf(records), roundings);
    int different = 0;
    int other_cell = 0;
    double worst = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
      if (Vec3(texels[i]) != Vec3(expected[i])) ++different;
      // The direction is found through a division, which a device may round otherwise: then one on
      // the border of two cells may fall into the other.
      if (texels[i].w == expected[i].w) continue;
      ++other_cell;
      worst = std::max(worst, test::angleBetween(glsl_float::decodeHitRecord(texels[i]).direction,
                                                 records[i].direction));
    }
    test::report("{}: of {} records {} differ, {} have their direction in another cell",
                 context.name(), kCount, different, other_cell);
    CHECK(different == 0);
    CHECK(other_cell < static_cast<int>(kCount / 100));
    CHECK(worst < 1.4e-4);
  });
}

TEST_CASE("the device decodes hit records as C++ does") {
  const std::vector<HitRecord> records = randomRecords();
  std::vector<Vec4> texels = encodeInCpp(records, randomRoundings());
  std::erase_if(texels, [](const Vec4& texel) { return glsl_float::isEnded(texel); });
  test::onEveryContext([&](const test::TestContext& context) {
    CAPTURE(context.name());
    const std::vector<RecordValues> decoded = decodeRecords(context.device(), texels);
    int different = 0;
    double worst_angle = 0;
    for (std::size_t i = 0; i < texels.size(); ++i) {
      const HitRecord r = glsl_float::decodeHitRecord(texels[i]);
      const RecordValues& is = decoded[i];
      const bool same = is.triangle == r.triangle && is.back == r.back && is.uv == r.uv &&
                        is.throughput == r.throughput && is.weight == r.weight && !is.ended;
      if (!same) ++different;
      worst_angle = std::max(worst_angle, test::angleBetween(is.direction, r.direction));
    }
    test::report("{}: of {} records {} differ, directions by up to {:.1e} rad", context.name(),
                 texels.size(), different, worst_angle);
    CHECK(different == 0);
    CHECK(worst_angle < 1e-6);
  });
}
