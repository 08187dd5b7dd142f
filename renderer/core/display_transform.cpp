#include "renderer/core/display_transform.h"

#include <algorithm>
#include <cmath>

namespace glimt {
namespace {

// IEC 61966-2-1, from 0 to 1.
float encodeSrgb(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

// In this order, so that no light times an infinite scale is black.
Vec3 exposed(const Vec3& radiance, float scale, float most) {
  Vec3 light;
  for (int c = 0; c < 3; ++c) light[c] = std::min(std::max(0.0f, radiance[c] * scale), most);
  return light;
}

// What the curves take; see limitLight in shaders/display_transform.glsl.
constexpr float kMostLight = 65504;

// The rows of a matrix.
Vec3 multiply(const Vec3& first, const Vec3& second, const Vec3& third, const Vec3& v) {
  return {glm::dot(first, v), glm::dot(second, v), glm::dot(third, v)};
}

// As shaders/tone_agx.glsl, whose comments say what it is.
Vec3 toneAgx(const Vec3& light) {
  constexpr float kLow = -12.47393f;
  constexpr float kHigh = 4.026069f;
  const Vec3 wide = multiply({0.6274f, 0.3293f, 0.0433f}, {0.0691f, 0.9195f, 0.0113f},
                             {0.0164f, 0.0880f, 0.8956f}, light);
  const Vec3 inset = multiply({0.856627153315983f, 0.0951212405381588f, 0.0482516061458583f},
                              {0.137318972929847f, 0.761241990602591f, 0.101439036467562f},
                              {0.11189821299995f, 0.0767994186031903f, 0.811302368396859f}, wide);
  const Vec3 stops = glm::log2(glm::max(inset, Vec3(1e-10f)));
  const Vec3 x = glm::clamp((stops - kLow) / (kHigh - kLow), 0.0f, 1.0f);
  const Vec3 x2 = x * x;
  const Vec3 x4 = x2 * x2;
  const Vec3 curve = 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x +
                     0.4298f * x2 + 0.1191f * x - 0.00232f;
  const Vec3 outset =
      multiply({1.1271005818144368f, -0.11060664309660323f, -0.016493938717834573f},
               {-0.1413297634984383f, 1.157823702216272f, -0.016493938717834257f},
               {-0.14132976349843826f, -0.11060664309660294f, 1.2519364065950405f}, curve);
  return multiply({1.6605f, -0.5876f, -0.0728f}, {-0.1246f, 1.1329f, -0.0083f},
                  {-0.0182f, -0.1006f, 1.1187f}, glm::pow(glm::max(outset, Vec3(0)), Vec3(2.2f)));
}

// As shaders/tone_aces.glsl.
Vec3 toneAces(const Vec3& light) {
  const Vec3 v = multiply({0.59719f, 0.35458f, 0.04823f}, {0.07600f, 0.90834f, 0.01566f},
                          {0.02840f, 0.13383f, 0.83777f}, light / 0.6f);
  const Vec3 curve =
      (v * (v + 0.0245786f) - 0.000090537f) / (v * (0.983729f * v + 0.4329510f) + 0.238081f);
  return multiply({1.60475f, -0.53108f, -0.07367f}, {-0.10208f, 1.10813f, -0.00605f},
                  {-0.00327f, -0.07276f, 1.07602f}, curve);
}

// In [0, 1], linear.
Vec3 shownLight(const Vec3& radiance, float scale, Tone tone) {
  switch (tone) {
    case Tone::agx:
      return glm::clamp(toneAgx(exposed(radiance, scale, kMostLight)), 0.0f, 1.0f);
    case Tone::aces:
      return glm::clamp(toneAces(exposed(radiance, scale, kMostLight)), 0.0f, 1.0f);
    case Tone::srgb:
      break;
  }
  return exposed(radiance, scale, 1);
}

}  // namespace

DisplayImage displayImage(const Image& radiance, float exposure, Tone tone) {
  const float scale = std::exp2(exposure);
  DisplayImage display{radiance.width, radiance.height, {}, {}, radiance.denoised};
  display.bytes.reserve(3 * radiance.pixels.size());
  for (std::size_t i = 0; i < radiance.pixels.size(); ++i) {
    // What covers a part of a pixel is as bright as if it covered the whole.
    const float alpha = radiance.alpha.empty() ? 1 : radiance.alpha[i];
    const Vec3 covering = alpha > 0 ? radiance.pixels[i] / alpha : Vec3(0);
    const Vec3 shown = shownLight(covering, scale, tone);
    for (int channel = 0; channel < 3; ++channel) {
      const float value = encodeSrgb(shown[channel]);
      display.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * value)));
    }
    if (!radiance.alpha.empty())
      display.alpha.push_back(static_cast<std::uint8_t>(std::lround(255 * alpha)));
  }
  return display;
}

}  // namespace glimt
