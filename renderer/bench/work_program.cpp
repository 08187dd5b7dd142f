#include "renderer/bench/work_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "renderer/bench/stopwatch.h"
#include "renderer/shader/composer.h"

namespace glimt {
namespace {

// Long enough that starting a draw costs nothing beside it.
constexpr double kDrawSeconds = 0.05;

// A driver may end all loops silently after some 65,500 turns.
constexpr int kFewestTurns = 4;
constexpr int kMostTurns = 8192;

std::string shaderOf(const DeviceWork& work, int turns) {
  const std::string text = fmt::format("\n#define TURNS {}\n{}", turns, work.text);
  return work.traversal.empty() ? composeProbe({}, text)
                                : composeTraversalProbe(work.traversal, text);
}

// What `turns` turns took `seconds` for.
int turnsFor(double seconds, int turns) {
  const double wanted = turns * kDrawSeconds / seconds;
  const double within = std::clamp<double>(wanted, kFewestTurns, kMostTurns);
  return static_cast<int>(std::bit_floor(static_cast<unsigned>(within)));
}

}  // namespace

WorkProgram::WorkProgram(const gl::Device& device, const DeviceWork& work,
                         const gl::Texture& texels, const gl::Target& target, const gl::Tile& tile)
    : device_(&device), work_(work), texels_(&texels), target_(&target), tile_(tile) {
  compile(kFewestTurns);
  draw();
  const int turns = turnsFor(draw(), kFewestTurns);
  if (turns != turns_) compile(turns);
}

std::vector<double> WorkProgram::run(int repeats) {
  draw();
  std::vector<double> seconds;
  for (int repeat = 0; repeat < repeats; ++repeat) seconds.push_back(draw());
  return seconds;
}

void WorkProgram::compile(int turns) {
  turns_ = turns;
  program_.emplace(device_->gl(), work_.name, composeVertexShader(), shaderOf(work_, turns));
}

double WorkProgram::draw() {
  program_->use();
  program_->set("uZero", Vec4(0));
  program_->set("uTexels", *texels_);
  program_->set("uTexelStep", 1.0f / Vec2(texels_->width(), texels_->height()));
  target_->bind();
  return secondsOf(*device_, [&] { device_->draw(tile_); });
}

}  // namespace glimt
