#include "renderer/bench/device_ceilings.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/bench/chain_texture.h"
#include "renderer/bench/device_work.h"
#include "renderer/bench/stopwatch.h"
#include "renderer/bench/work_program.h"
#include "renderer/core/error.h"

namespace glimt {
namespace {

constexpr std::size_t kMib = std::size_t{1} << 20;
constexpr std::size_t kSizes[]{kSmallTexture, kMib, 16 * kMib, 128 * kMib};
constexpr std::size_t kChains[]{kMib, 16 * kMib};

class CeilingBench {
 public:
  using Progress = std::function<void(const std::string&)>;

  CeilingBench(const gl::Device& device, const DeviceBenchSettings& settings,
               const Progress& progress)
      : device_(&device), settings_(&settings), progress_(&progress) {
    for (const int side : settings.sides)
      targets_.emplace_back(gl::Texture::floats(device.gl(), device.floatForm(), side, side));
  }

  std::vector<DeviceRow> run() {
    for (const DeviceWork& work : arithmeticWorks()) measure(work);
    measure(sameTexelWork());
    measure(neighboursWork());
    for (const std::size_t bytes : kSizes)
      if (wanted(bytes)) measure(randomTexelsWork(bytes));
    for (const std::size_t bytes : kChains)
      if (wanted(bytes)) measure(chainWork(bytes));
    for (const std::size_t bytes : kChains)
      if (wanted(bytes)) measureStep(chainWork(bytes));
    return rows_;
  }

 private:
  bool wanted(std::size_t bytes) const { return bytes <= settings_->largest_texture; }

  // In pictures of every size.
  void measure(const DeviceWork& work) {
    const auto texels = texelsOf(work);
    if (!texels) return;
    for (const gl::Target& target : targets_) {
      const int side = target.width();
      (*progress_)(fmt::format("{}, {} x {}", work.name, side, side));
      WorkProgram program(*device_, work, *texels, target, {0, 0, side, side});
      const double pixels = static_cast<double>(side) * side;
      const double billions = pixels * program.amountPerPixel() / 1e9;
      const Spread seconds = spreadOf(program.run(settings_->repeats));
      add(work.name, work.unit, side).rate =
          Spread{billions / seconds.median, billions / seconds.most, billions / seconds.least};
    }
  }

  // One pixel has nothing else to do than to wait for the next texel.
  void measureStep(const DeviceWork& work) {
    const auto texels = texelsOf(work);
    if (!texels) return;
    (*progress_)(work.name + ", one pixel");
    WorkProgram program(*device_, work, *texels, targets_.front(), {0, 0, 1, 1});
    const Spread seconds = spreadOf(program.run(settings_->repeats));
    const double scale = 1e9 / program.amountPerPixel();
    add(work.name + ", one pixel", "ns/step", 1).rate =
        Spread{scale * seconds.median, scale * seconds.least, scale * seconds.most};
  }

  // None, with a row that says so, where the device has no textures of that size.
  std::optional<gl::Texture> texelsOf(const DeviceWork& work) {
    try {
      return makeChainTexture(*device_, std::max(work.texture_bytes, sizeof(Vec4)));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::input) throw;
      for (const gl::Target& target : targets_)
        add(work.name, work.unit, target.width()).note = error.what();
      return std::nullopt;
    }
  }

  DeviceRow& add(const std::string& work, const std::string& unit, int side) {
    rows_.push_back({work, unit, side, {}, {}});
    return rows_.back();
  }

  const gl::Device* device_;
  const DeviceBenchSettings* settings_;
  const Progress* progress_;
  std::vector<gl::Target> targets_;
  std::vector<DeviceRow> rows_;
};

}  // namespace

std::vector<DeviceRow> measureCeilings(const gl::Device& device,
                                       const DeviceBenchSettings& settings,
                                       const std::function<void(const std::string&)>& progress) {
  return CeilingBench(device, settings, progress).run();
}

}  // namespace glimt
