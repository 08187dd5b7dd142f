#include <fmt/format.h>

#include "app/commands.h"
#include "app/json_output.h"
#include "renderer/core/image_difference.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

Json reportOf(const CompareOptions& options, const Image& image, const ImageDifference& d) {
  return {{"image", options.image.string()},
          {"reference", options.reference.string()},
          {"width", image.width},
          {"height", image.height},
          {"mean_ratio", jsonOf(d.mean_ratio)},
          {"mse", d.mse},
          {"relative_mse", d.relative_mse},
          {"noise", d.noise},
          {"psnr", d.psnr},  // null, as JSON has no infinity, where the pictures are equal
          {"largest", d.largest}};
}

std::string textOf(const ImageDifference& d) {
  return fmt::format(
      "mean ratio  {:.5f} {:.5f} {:.5f}\n"
      "MSE         {:.6g}\n"
      "relMSE      {:.6g}\n"
      "noise       {}\n"
      "PSNR        {:.2f} dB\n"
      "largest     {:.6g}\n",
      d.mean_ratio.x, d.mean_ratio.y, d.mean_ratio.z, d.mse, d.relative_mse, percent(d.noise),
      d.psnr, d.largest);
}

}  // namespace

int runCompare(const CompareOptions& options) {
  checkJsonFile(options.json);
  const Image image = readImage(options.image);
  const ImageDifference difference = differenceOf(image, readImage(options.reference));
  if (options.json.empty()) {
    writeOut(textOf(difference));
  } else {
    writeJson(options.json, reportOf(options, image, difference));
  }
  return 0;
}

}  // namespace glimt
