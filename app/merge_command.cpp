#include <fmt/format.h>

#include "app/commands.h"
#include "app/message.h"
#include "app/output_files.h"
#include "app/picture_files.h"
#include "app/share/share.h"
#include "renderer/core/error.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

Share joined(const std::vector<std::filesystem::path>& files) {
  ShareSum sum;
  for (const std::filesystem::path& file : files) {
    try {
      sum.add(shareOf(readLayers(file)));
    } catch (const Error& error) {
      const std::string what = error.what();
      if (what.starts_with(printable(file.string()))) throw;
      throw Error(error.kind(), fmt::format("{}: {}", printable(file.string()), what));
    }
  }
  return sum.share();
}

std::string textOf(const std::vector<SampleRange>& ranges) {
  std::string text;
  for (const SampleRange& range : ranges)
    text += fmt::format("{}{} to {}", text.empty() ? "" : ", ", range.first, range.end() - 1);
  return text;
}

}  // namespace

int runMerge(const MergeOptions& options) {
  for (const auto& output : options.outputs) {
    imageFormatOf(output);
    checkWritable(output);
  }
  const Share share = joined(options.shares);
  for (const auto& output : options.outputs) {
    if (imageFormatOf(output) == ImageFormat::exr)
      writeLayers(output, layersOf(share));
    else
      writePicture(output, share.mean, options.exposure, options.tone);
  }
  if (share.ranges.size() > 1 || share.ranges.front().first != 0)
    say(fmt::format("warning: samples are missing, there are {}", textOf(share.ranges)));
  if (!options.quiet)
    sayPlain(fmt::format("{}, noise at most about {}",
                         counted(static_cast<std::uintmax_t>(samplesOf(share)), "sample"),
                         percent(independentNoise(share))));
  return 0;
}

}  // namespace glimt
