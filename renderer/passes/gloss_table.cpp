#include "renderer/passes/gloss_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/passes/sheen_albedo.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

using Vec3d = glm::dvec3;

constexpr int kSteps = 24;  // of the quadrature, in either dimension

double lambda(const Vec3d& w, double alpha) {
  const double tangent2 = (w.x * w.x + w.y * w.y) / std::max(w.z * w.z, 1e-300);
  return 0.5 * (std::sqrt(1 + alpha * alpha * tangent2) - 1);
}

// As in shaders/ggx.glsl.
Vec3d visibleNormal(const Vec3d& wo, double alpha, double u, double v) {
  const Vec3d stretched = glm::normalize(Vec3d(alpha * wo.x, alpha * wo.y, wo.z));
  const double angle = 2 * std::numbers::pi * u;
  const double z = 1 - v * (1 + stretched.z);
  const double radius = std::sqrt(std::clamp(1 - z * z, 0.0, 1.0));
  const Vec3d seen = Vec3d(radius * std::cos(angle), radius * std::sin(angle), z) + stretched;
  return glm::normalize(Vec3d(alpha * seen.x, alpha * seen.y, std::max(seen.z, 0.0)));
}

}  // namespace

// Integrates over visible normals, whose density leaves only masking and Fresnel to average.
Vec2 glossAlbedoOf(double cosine, double roughness) {
  const double alpha = std::max(roughness * roughness, 1e-6);
  const Vec3d wo(std::sqrt(std::max(1 - cosine * cosine, 0.0)), 0, cosine);
  const double lambda_o = lambda(wo, alpha);
  double at_normal = 0;
  double at_horizon = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const Vec3d normal = visibleNormal(wo, alpha, (i + 0.5) / kSteps, (j + 0.5) / kSteps);
      const double toward = glm::dot(wo, normal);
      const Vec3d wi = 2 * toward * normal - wo;
      if (!(wi.z > 0)) continue;
      const double weight = (1 + lambda_o) / (1 + lambda_o + lambda(wi, alpha));
      const double horizon = std::pow(std::clamp(1 - toward, 0.0, 1.0), 5);
      at_normal += weight * (1 - horizon);
      at_horizon += weight * horizon;
    }
  return Vec2(at_normal, at_horizon) / static_cast<float>(kSteps * kSteps);
}

std::vector<Vec4> glossTable(bool with_sheen) {
  const int size = static_cast<int>(GLOSS_TABLE_SIZE);
  std::vector<Vec4> texels;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const double x = static_cast<double>(column) / (size - 1);
      const double roughness = static_cast<double>(row) / (size - 1);
      const double cosine = std::max(x * x, 1e-6);
      const double sheen = with_sheen ? sheenAlbedoOf(cosine, roughness) : 0;
      texels.emplace_back(glossAlbedoOf(cosine, roughness), sheen, 0);
    }
  return texels;
}

gl::Texture makeGlossTexture(const gl::Device& device, const EffectSet& effects) {
  const bool sheen = has(effects, Effect::sheen);
  const bool needed = sheen || has(effects, Effect::gloss) || has(effects, Effect::mirror) ||
                      has(effects, Effect::clearcoat) || has(effects, Effect::thin_walls);
  const int size = needed ? static_cast<int>(GLOSS_TABLE_SIZE) : 1;
  return gl::Texture::floats(device.gl(), device.floatForm(), size, size,
                             needed ? glossTable(sheen) : std::vector<Vec4>(1));
}

}  // namespace glimt
