#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr ImU32 kFrame = IM_COL32(90, 92, 100, 255);
constexpr ImU32 kGrid = IM_COL32(58, 60, 66, 255);
constexpr ImU32 kText = IM_COL32(150, 152, 160, 255);
constexpr ImU32 kLine = IM_COL32(95, 170, 255, 255);
constexpr ImU32 kBand = IM_COL32(95, 170, 255, 60);
constexpr ImU32 kGoal = IM_COL32(120, 210, 120, 255);

// A logarithmic axis between two powers of ten.
struct Axis {
  double low = 0;  // exponents
  double high = 1;
  float begin = 0;  // pixels
  float end = 1;

  float at(double value) const {
    const double share = (std::log10(value) - low) / (high - low);
    return begin + static_cast<float>(std::clamp(share, 0.0, 1.0)) * (end - begin);
  }
};

Axis samplesAxis(const std::vector<NoiseEstimate>& points, float begin, float end) {
  const double most = points.empty() ? 100 : points.back().samples;
  return {std::log10(8.0), std::max(std::ceil(std::log10(most)), 2.0), begin, end};
}

Axis noiseAxis(const std::vector<NoiseEstimate>& points, float goal, float begin, float end) {
  double low = std::min(goal, 0.01f);
  double high = std::max(goal, 0.1f);
  for (const NoiseEstimate& point : points) {
    low = std::min(low, point.relative);
    high = std::max(high, point.relative);
  }
  return {std::floor(std::log10(std::max(low, 1e-6))), std::ceil(std::log10(high)), begin, end};
}

}  // namespace

// Noise over samples, both logarithmic, with where it is in 95% of the cases.
void drawNoiseCurve(const NoiseHistory& noise, float goal) {
  const std::vector<NoiseEstimate>& points = noise.points();
  const float line = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, 7 * line);
  const float left = corner.x + 3.1f * line;
  const float right = corner.x + size.x - 0.6f * line;
  const float top = corner.y + 0.5f * line;
  const float bottom = corner.y + size.y - 1.3f * line;
  const Axis x = samplesAxis(points, left, right);
  const Axis y = noiseAxis(points, goal, bottom, top);
  ImDrawList& list = *ImGui::GetWindowDrawList();

  for (double e = y.low; e <= y.high + 0.01; ++e) {
    const float height = y.at(std::pow(10, e));
    list.AddLine({left, height}, {right, height}, kGrid);
    const std::string label = percent(std::pow(10, e));
    const float width = ImGui::CalcTextSize(label.c_str()).x;
    list.AddText({left - width - 5, height - 0.5f * line}, kText, label.c_str());
  }
  for (double e = 1; e <= x.high + 0.01; ++e) {
    const float across = x.at(std::pow(10, e));
    list.AddLine({across, top}, {across, bottom}, kGrid);
    const std::string label = grouped(static_cast<std::uintmax_t>(std::pow(10, e)));
    const float width = ImGui::CalcTextSize(label.c_str()).x;
    list.AddText({std::min(across - 0.5f * width, right - width + 0.5f * line), bottom + 2}, kText,
                 label.c_str());
  }
  list.AddRect({left, top}, {right, bottom}, kFrame);
  const float goal_height = y.at(goal);
  list.AddLine({left, goal_height}, {right, goal_height}, kGoal, 1.5f);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const NoiseEstimate& a = points[i - 1];
    const NoiseEstimate& b = points[i];
    const float xa = x.at(a.samples);
    const float xb = x.at(b.samples);
    list.AddQuadFilled({xa, y.at(std::max(a.lower, 1e-9))}, {xb, y.at(std::max(b.lower, 1e-9))},
                       {xb, y.at(b.upper)}, {xa, y.at(a.upper)}, kBand);
    list.AddLine({xa, y.at(a.relative)}, {xb, y.at(b.relative)}, kLine, 2);
  }
  ImGui::Dummy(size);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("noise over samples, and the goal");
}

}  // namespace glimt
