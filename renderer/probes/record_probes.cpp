#include "renderer/probes/record_probes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "renderer/probes/probe.h"

namespace glimt {
namespace {

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

constexpr std::size_t kRecords = std::size_t{1} << 16;
constexpr std::size_t kRoundings = std::size_t{1} << 18;

// The steps of the fields, as hit_record.glsl has them, and for directions the largest angle.
constexpr float kUvStep = 1.0f / 65536;
constexpr float kColorStep = 1.0f / 63.5f;  // of the largest channel
constexpr float kWeightStep = 1.0f / 127;
constexpr float kDirectionError = 1.4e-4f;

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  // A multiple of 2^-23 in [0, 1).
  float uniform() { return static_cast<float>(engine_() >> 9) * 0x1p-23f; }
  Vec4 four() {
    Vec4 values;
    for (int i = 0; i < 4; ++i) values[i] = uniform();
    return values;
  }
  Vec3 direction() {
    const float z = 2 * uniform() - 1;
    const float angle = 6.2831853f * uniform();
    const float r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

 private:
  std::mt19937 engine_;
};

RecordValues randomRecord(Random& random) {
  RecordValues record;
  record.triangle = std::floor(random.uniform() * 8388606.0f);
  record.back = random.uniform() < 0.5f ? 1.0f : 0.0f;
  record.uv = Vec2(random.uniform(), random.uniform());
  if (record.uv.x + record.uv.y > 1) record.uv = 1.0f - record.uv;
  record.direction = random.direction();
  const float strength = std::exp2(60 * random.uniform() - 35);
  record.throughput = strength * Vec3(random.uniform(), random.uniform(), 1);
  record.weight = random.uniform();
  return record;
}

bool isClose(const RecordValues& is, const RecordValues& expected) {
  const auto within = [](const auto& difference, float most) {
    return glm::all(glm::lessThanEqual(glm::abs(difference), decltype(difference + 0.0f)(most)));
  };
  const Vec3 color = is.throughput - expected.throughput;
  // The sine of the angle, which is the angle where it is small.
  const float angle = glm::length(glm::cross(is.direction, expected.direction));
  return !is.ended && is.triangle == expected.triangle && is.back == expected.back &&
         within(is.uv - expected.uv, 2 * kUvStep) &&
         within(color, expected.throughput.z * kColorStep) &&
         std::abs(is.weight - expected.weight) <= kWeightStep && angle <= kDirectionError &&
         glm::dot(is.direction, expected.direction) > 0;
}

// Those that are rounded stochastically.
std::array<double, 6> roundedFields(const RecordValues& record) {
  return {record.throughput.x, record.throughput.y, record.throughput.z,
          record.weight,       record.uv.x,         record.uv.y};
}

}  // namespace

std::vector<Vec4> encodeRecords(const gl::Device& device, const std::vector<RecordValues>& records,
                                const std::vector<Vec4>& random) {
  std::vector<std::vector<Vec4>> lists(3);
  for (const RecordValues& record : records) {
    lists[0].emplace_back(record.triangle, record.back, record.uv);
    lists[1].emplace_back(record.direction, 0);
    lists[2].emplace_back(record.throughput, record.weight);
  }
  lists.push_back(random);
  return Probe(device, kFiles, kEncode, 4).run(lists);
}

std::vector<RecordValues> decodeRecords(const gl::Device& device, const std::vector<Vec4>& texels) {
  Probe probe(device, kFiles, kDecode);
  const auto part = [&](float which) {
    return probe.run({texels}, [&](gl::Program& program) { program.set("uPart", which); });
  };
  const std::vector<Vec4> first = part(0), second = part(1), third = part(2);
  std::vector<RecordValues> records;
  for (std::size_t i = 0; i < texels.size(); ++i)
    records.push_back({first[i].x, first[i].y, Vec2(first[i].z, first[i].w), Vec3(third[i]),
                       Vec3(second[i]), second[i].w, third[i].w != 0});
  return records;
}

RecordProbe probeRecords(const gl::Device& device) {
  Random random(31);
  std::vector<RecordValues> records;
  std::vector<Vec4> rounding;
  for (std::size_t i = 0; i < kRecords; ++i) {
    records.push_back(randomRecord(random));
    rounding.push_back(random.four());
  }
  const auto found = decodeRecords(device, encodeRecords(device, records, rounding));
  RecordProbe probe{kRecords, 0};
  for (std::size_t i = 0; i < kRecords; ++i) probe.wrong += !isClose(found[i], records[i]);
  return probe;
}

double probeRounding(const gl::Device& device) {
  Random random(32);
  RecordValues record;
  record.triangle = 1234567;
  record.uv = Vec2(0.2345678f, 0.3456789f);
  record.direction = Vec3(0.48f, -0.64f, 0.6f);
  record.throughput = Vec3(0.7654321f, 0.1234567f, 0.0345678f);
  record.weight = 0.4321987f;
  std::vector<Vec4> rounding;
  for (std::size_t i = 0; i < kRoundings; ++i) rounding.push_back(random.four());
  const std::vector<RecordValues> records(kRoundings, record);
  const auto found = decodeRecords(device, encodeRecords(device, records, rounding));

  const auto expected = roundedFields(record);
  double worst = 0;
  for (std::size_t field = 0; field < expected.size(); ++field) {
    double sum = 0, squares = 0;
    for (const RecordValues& values : found) {
      const double off = roundedFields(values)[field] - expected[field];
      sum += off;
      squares += off * off;
    }
    const double n = static_cast<double>(kRoundings);
    const double variance = squares / n - (sum / n) * (sum / n);
    // All alike are exact, or wrong by what the error of a single one would hide.
    const double error = std::sqrt(variance / n) + 1e-9;
    worst = std::max(worst, std::abs(sum / n) / error);
  }
  return worst;
}

}  // namespace glimt
