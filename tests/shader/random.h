// Random numbers for tests: the same in every run.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>
#include <random>

namespace glimt::test {

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  std::uint32_t bits() { return static_cast<std::uint32_t>(engine_()); }
  std::uint32_t below(std::uint32_t n) { return bits() % n; }

  // A multiple of 2^-23 in [0, 1), like those that the shaders get.
  float uniform() { return static_cast<float>(bits() >> 9) * 0x1p-23f; }
  float uniform(float from, float to) { return from + (to - from) * uniform(); }
  float logUniform(float from, float to) { return from * std::pow(to / from, uniform()); }

  glm::vec2 square() { return {uniform(), uniform()}; }
  glm::vec3 cube() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
  glm::vec4 four() { return {uniform(), uniform(), uniform(), uniform()}; }

  // Uniform over the sphere, unit to the last bits.
  glm::vec3 direction() {
    const double z = uniform(-1, 1);
    const double angle = 2 * std::numbers::pi * uniform();
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

  // Weights of vertices 1 and 2 of a triangle.
  glm::vec2 weights() {
    const glm::vec2 p = square();
    return p.x + p.y > 1 ? 1.0f - p : p;
  }

 private:
  std::mt19937 engine_;
};

// Between two vectors, in radians; exact for small angles too.
inline double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace glimt::test
