// The hit record packed and unpacked by the device is the one that C++ packs and unpacks.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/gpu/contexts.h"
#include "tests/gpu/probe.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;
using glsl_float::HitRecord;

namespace {

constexpr std::size_t kCount = 60000;

const std::vector<std::string> kFiles{"constants.glsl", "float_fields.glsl", "octahedral.glsl",
                                      "hit_record.glsl"};

constexpr const char* kEncode = R"(
vec4 probe(vec4 a, vec4 b, vec4 c, vec4 random) {
  return encodeHitRecord(HitRecord(a.x, a.y, a.zw, b.xyz, c.xyz, c.w), random);
})";

// Four values of the record at a time.
constexpr const char* kDecode = R"(
uniform float uPart;
vec4 probe(vec4 texel) {
  HitRecord record = decodeHitRecord(texel);
  vec4 first = vec4(record.triangle, record.back, record.uv);
  vec4 second = vec4(record.throughput, record.weight);
  vec4 third = vec4(record.direction, isEnded(texel) ? 1.0 : 0.0);
  return uPart < 0.5 ? first : uPart < 1.5 ? second : third;
})";

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

std::vector<std::vector<Vec4>> asInputs(const std::vector<HitRecord>& records) {
  test::Random random(33);
  std::vector<std::vector<Vec4>> lists(4);
  for (const HitRecord& r : records) {
    lists[0].emplace_back(r.triangle, r.back, r.uv);
    lists[1].emplace_back(r.direction, 0);
    lists[2].emplace_back(r.throughput, r.weight);
    lists[3].push_back(random.four());
  }
  return lists;
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
  const auto inputs = asInputs(records);
  const std::vector<Vec4> expected = encodeInCpp(records, inputs[3]);
  test::onEveryContext([&](const test::TestContext& context) {
    CAPTURE(context.name());
    const std::vector<Vec4> texels = test::Probe(context.device(), kFiles, kEncode, 4).run(inputs);
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
  std::vector<Vec4> texels = encodeInCpp(records, asInputs(records)[3]);
  std::erase_if(texels, [](const Vec4& texel) { return glsl_float::isEnded(texel); });
  test::onEveryContext([&](const test::TestContext& context) {
    CAPTURE(context.name());
    test::Probe probe(context.device(), kFiles, kDecode);
    const auto part = [&](float which) {
      return probe.run({texels}, [&](gl::Program& program) { program.set("uPart", which); });
    };
    const std::vector<Vec4> first = part(0), second = part(1), third = part(2);
    int different = 0;
    double worst_angle = 0;
    for (std::size_t i = 0; i < texels.size(); ++i) {
      const HitRecord r = glsl_float::decodeHitRecord(texels[i]);
      const bool same = first[i] == Vec4(r.triangle, r.back, r.uv) &&
                        second[i] == Vec4(r.throughput, r.weight) && third[i].w == 0;
      if (!same) ++different;
      worst_angle = std::max(worst_angle, test::angleBetween(Vec3(third[i]), r.direction));
    }
    test::report("{}: of {} records {} differ, directions by up to {:.1e} rad", context.name(),
                 texels.size(), different, worst_angle);
    CHECK(different == 0);
    CHECK(worst_angle < 1e-6);
  });
}
