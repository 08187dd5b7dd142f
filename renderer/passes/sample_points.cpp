#include "renderer/passes/sample_points.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "shaders/layout.h"

namespace glimt {
namespace {

using Directions = std::array<std::uint32_t, 32>;

// Primitive polynomials and first direction numbers of Joe and Kuo 2008, dimensions 2 to 4.
struct Polynomial {
  int degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 3> first;
};
constexpr std::array<Polynomial, 3> kPolynomials{
    {{1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}}};

constexpr Directions makeDirections(const Polynomial& polynomial) {
  Directions v{};
  const int s = polynomial.degree;
  for (int i = 0; i < 32; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (i < s) {
      v[k] = polynomial.first[k] << (31 - i);
      continue;
    }
    v[k] = v[k - static_cast<std::size_t>(s)] ^ (v[k - static_cast<std::size_t>(s)] >> s);
    for (int j = 1; j < s; ++j)
      if (polynomial.coefficients >> (s - 1 - j) & 1u) v[k] ^= v[k - static_cast<std::size_t>(j)];
  }
  return v;
}

// The first dimension is van der Corput's.
constexpr std::array<Directions, 4> makeAllDirections() {
  std::array<Directions, 4> all{};
  for (std::size_t i = 0; i < 32; ++i) all[0][i] = 0x80000000u >> i;
  for (std::size_t d = 1; d < 4; ++d) all[d] = makeDirections(kPolynomials[d - 1]);
  return all;
}

constexpr std::array<Directions, 4> kDirections = makeAllDirections();

std::uint32_t sobol(std::uint32_t index, std::size_t dimension) {
  std::uint32_t x = 0;
  for (std::size_t bit = 0; index != 0; index >>= 1, ++bit)
    if (index & 1u) x ^= kDirections[dimension][bit];
  return x;
}

// Wellons' lowbias32.
std::uint32_t hash(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

std::uint32_t hash(std::uint32_t a, std::uint32_t b) {
  return hash(a ^ (hash(b) + 0x9e3779b9u));
}

// Owen's nested scrambling: each bit is flipped or not by a hash of all the bits above it, which
// are a node's place in a binary tree. Cheaper hashes of the whole number at once (Laine and Karras
// 2011) leave some pairs of sets correlated over the frames.
std::uint32_t scramble(std::uint32_t x, std::uint32_t seed) {
  std::uint32_t flips = 0;
  std::uint32_t node = 1;
  for (int bit = 31; bit >= 0; --bit) {
    flips |= hash(node ^ seed) >> 31 << bit;
    node = 2 * node + (x >> bit & 1u);
  }
  return x ^ flips;
}

float toUnit(std::uint32_t x) {
  return static_cast<float>(x >> 9) * 0x1p-23f;
}

}  // namespace

Vec4 SamplePoints::point(std::uint32_t sample, std::uint32_t set, std::uint32_t group) const {
  const std::uint32_t set_seed = hash(hash(seed_, set), group);
  Vec4 point;
  if (sampler_ == Sampler::random) {
    const std::uint32_t of_sample = hash(set_seed, sample);
    for (std::uint32_t d = 0; d < 4; ++d) point[static_cast<int>(d)] = toUnit(hash(of_sample, d));
    return point;
  }
  // Scrambling an index shuffles each aligned block of 2^k of them among themselves, so the first
  // 2^k points remain a net.
  const std::uint32_t index = scramble(sample, set_seed);
  for (std::size_t d = 0; d < 4; ++d)
    point[static_cast<int>(d)] =
        toUnit(scramble(sobol(index, d), hash(set_seed, static_cast<std::uint32_t>(d) + 1)));
  return point;
}

void SamplePoints::bindPoints(gl::Program& program, const std::string& array, std::uint32_t sample,
                              std::uint32_t set, std::uint32_t place) const {
  for (std::uint32_t group = 0; group < POINT_GROUPS; ++group)
    program.set(fmt::format("{}[{}]", array, POINT_GROUPS * place + group),
                point(sample, set, group));
}

Vec4 SamplePoints::offsetsShift(std::uint32_t set) const {
  const std::uint32_t a = hash(hash(seed_, set), 0x5bd1e995u);
  const auto byte = [](std::uint32_t x, int i) { return static_cast<float>(x >> (8 * i) & 0xffu); };
  return {byte(a, 0), byte(a, 1), byte(a, 2), byte(a, 3)};
}

gl::Texture SamplePoints::makeOffsets(const gl::Device& device) const {
  constexpr auto kSize = static_cast<std::uint32_t>(OFFSETS_SIZE);
  std::vector<Vec4> texels;
  texels.reserve(kSize * kSize);
  for (std::uint32_t i = 0; i < kSize * kSize; ++i) {
    const auto number = [&](std::uint32_t k) {
      return toUnit(hash(hash(seed_, 0x2545f491u), 4 * i + k));
    };
    texels.emplace_back(number(0), number(1), number(2), number(3));
  }
  return gl::Texture::floats(device.gl(), device.floatForm(), kSize, kSize, texels);
}

}  // namespace glimt
