#include "renderer/passes/gloss_table.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <thread>

#include "renderer/bvh/parallel_for.h"
#include "renderer/passes/sheen_albedo.h"
#include "renderer/scene/transmission.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

using Vec3d = glm::dvec3;

// Steps of the quadrature, for errors of about a thousandth.
struct Steps {
  int turns;
  int heights;
};
constexpr Steps kGlossSteps{16, 40};
constexpr Steps kGlassSteps{32, 64};  // beyond some angle all is reflected: that takes more

// Of rough glass; others get the nearest.
constexpr std::size_t kMostIors = 15;

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

// Calls visit(normal, weight) for visible normals; the weights add up to 1. One half is enough, the
// other is its mirror image. Steps are shorter towards the normals that are seen edge-on, among
// which reflections begin to lead below the horizon.
template <typename Visit>
void visitNormals(const Vec3d& wo, double alpha, const Steps& steps, Visit&& visit) {
  for (int i = 0; i < steps.turns; ++i)
    for (int j = 0; j < steps.heights; ++j) {
      const double t = 1 - (j + 0.5) / steps.heights;
      visit(visibleNormal(wo, alpha, (i + 0.5) / (2 * steps.turns), 1 - t * t),
            2 * t / (steps.turns * steps.heights));
    }
}

double alphaOf(double roughness) {
  return std::max(roughness * roughness, 1e-6);
}

Vec3d directionOf(double cosine) {
  return {std::sqrt(std::max(1 - cosine * cosine, 0.0)), 0, cosine};
}

// Of the light that a microfacet sends on, what is not held up by others.
double passed(double lambda_o, const Vec3d& wi, double alpha) {
  return (1 + lambda_o) / (1 + lambda_o + lambda(wi, alpha));
}

double fresnel(double cosine, double refracted, double ior) {
  const double parallel = (ior * cosine - refracted) / (ior * cosine + refracted);
  const double perpendicular = (cosine - ior * refracted) / (cosine + ior * refracted);
  return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}

// A square of what texel(cosine, roughness) gives, as shaders/gloss_albedo.glsl reads it. Steps are
// short where the albedo changes most, near the horizon and where roughness begins.
template <typename Texel>
void addSquare(std::vector<Vec4>& texels, Texel&& texel) {
  constexpr double kLeastCosine = 1e-4;  // that there is; see surface.glsl
  const auto size = static_cast<std::size_t>(GLOSS_TABLE_SIZE);
  const std::size_t first = texels.size();
  texels.resize(first + size * size);
  parallelFor(std::thread::hardware_concurrency(), size, [&](std::size_t row) {
    const double roughness = std::pow(static_cast<double>(row) / (GLOSS_TABLE_SIZE - 1), 1.5);
    for (std::size_t column = 0; column < size; ++column) {
      const double cosine = std::pow(static_cast<double>(column) / (GLOSS_TABLE_SIZE - 1), 3);
      texels[first + row * size + column] = texel(std::max(cosine, kLeastCosine), roughness);
    }
  });
}

}  // namespace

// Integrates over visible normals, whose density leaves only masking and Fresnel to average.
Vec2 glossAlbedoOf(double cosine, double roughness) {
  const double alpha = alphaOf(roughness);
  const Vec3d wo = directionOf(cosine);
  const double lambda_o = lambda(wo, alpha);
  glm::dvec2 albedo(0);
  visitNormals(wo, alpha, kGlossSteps, [&](const Vec3d& normal, double share) {
    const double toward = glm::dot(wo, normal);
    const Vec3d wi = 2 * toward * normal - wo;
    if (!(wi.z > 0)) return;
    const double m = std::clamp(1 - toward, 0.0, 1.0);
    const double horizon = m * m * m * m * m;
    albedo += share * passed(lambda_o, wi, alpha) * glm::dvec2(1 - horizon, horizon);
  });
  return Vec2(albedo);
}

double glassAlbedoOf(double cosine, double roughness, double ior) {
  const double alpha = alphaOf(roughness);
  const Vec3d wo = directionOf(cosine);
  const double lambda_o = lambda(wo, alpha);
  double albedo = 0;
  visitNormals(wo, alpha, kGlassSteps, [&](const Vec3d& normal, double share) {
    const double toward = std::max(glm::dot(wo, normal), 1e-9);
    const double refracted = std::sqrt(std::max(ior * ior - 1 + toward * toward, 0.0)) / ior;
    const double reflectance = fresnel(toward, refracted, ior);
    const Vec3d reflected = 2 * toward * normal - wo;
    const Vec3d through = normal * (toward / ior - refracted) - wo / ior;
    if (reflected.z > 0) albedo += share * reflectance * passed(lambda_o, reflected, alpha);
    if (through.z < 0) albedo += share * (1 - reflectance) * passed(lambda_o, through, alpha);
  });
  // Rather too much: it is divided by, and errors of the quadrature must not make light.
  constexpr double kMargin = 0.005;
  return albedo * (1 + kMargin * std::max(1 - albedo, 0.0));
}

std::vector<float> tabulatedIors(const Scene& scene) {
  std::vector<float> iors;
  for (const Material& m : scene.materials) {
    const bool rough_glass = transmits(m) && m.roughness > 0 && !m.thin_walled;
    if (!rough_glass || iors.size() == kMostIors) continue;
    if (std::find(iors.begin(), iors.end(), m.ior) == iors.end()) iors.push_back(m.ior);
  }
  return iors;
}

std::size_t squareOfIor(const std::vector<float>& iors, float ior) {
  const auto nearest = std::min_element(iors.begin(), iors.end(), [ior](float a, float b) {
    return std::abs(a - ior) < std::abs(b - ior);
  });
  return nearest == iors.end() ? 0 : static_cast<std::size_t>(nearest - iors.begin()) + 1;
}

std::vector<Vec4> glossTable(bool with_sheen, const std::vector<float>& iors) {
  std::vector<Vec4> texels;
  addSquare(texels, [with_sheen](double cosine, double roughness) {
    const double of_fibres = 0.2 + 0.8 * std::pow(roughness, 2.0 / 3);
    const double sheen = with_sheen ? sheenAlbedoOf(cosine, of_fibres) : 0;
    return Vec4(glossAlbedoOf(cosine, roughness), sheen, 0);
  });
  for (const float ior : iors)
    addSquare(texels, [ior](double cosine, double roughness) {
      return Vec4(glassAlbedoOf(cosine, roughness, ior), glassAlbedoOf(cosine, roughness, 1 / ior),
                  0, 0);
    });
  // Textures that are repeated have to be powers of two.
  const std::size_t square = texels.size() / (iors.size() + 1);
  texels.resize(square * std::bit_ceil(iors.size() + 1));
  return texels;
}

GlossContents glossContentsOf(const Scene& scene, const EffectSet& effects) {
  const std::array kTabulated{Effect::gloss,      Effect::mirror,    Effect::rough_glass,
                              Effect::thin_walls, Effect::clearcoat, Effect::sheen};
  const bool needed = std::any_of(kTabulated.begin(), kTabulated.end(),
                                  [&](Effect effect) { return has(effects, effect); });
  if (!needed) return {};
  return {true, has(effects, Effect::sheen), tabulatedIors(scene)};
}

gl::Texture makeGlossTexture(const gl::Device& device, const GlossContents& contents) {
  if (!contents.needed)
    return gl::Texture::floats(device.gl(), device.floatForm(), 1, 1, {Vec4(0)});
  const std::vector<Vec4> texels = glossTable(contents.with_sheen, contents.iors);
  const int width = static_cast<int>(GLOSS_TABLE_SIZE);
  const int height = static_cast<int>(texels.size()) / width;
  return gl::Texture::floats(device.gl(), device.floatForm(), width, height, texels);
}

}  // namespace glimt
