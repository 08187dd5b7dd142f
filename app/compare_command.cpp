#include <fmt/format.h>

#include "app/commands.h"
#include "app/json_output.h"
#include "app/message.h"
#include "app/output_files.h"
#include "renderer/core/display_transform.h"
#include "renderer/core/error.h"
#include "renderer/core/flip.h"
#include "renderer/core/image_difference.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

Json reportOf(const CompareOptions& options, const Image& image, const Image& reference,
              const ImageDifference& d, double flip) {
  return {{"image", options.image.string()},
          {"reference", options.reference.string()},
          {"width", image.width},
          {"height", image.height},
          {"mean_ratio", jsonOf(d.mean_ratio)},
          {"mse", d.mse},
          {"relative_mse", d.relative_mse},
          {"noise", d.noise},
          {"psnr", d.psnr},  // null, as JSON has no infinity, where the pictures are equal
          {"flip", flip},
          {"denoised", {{"image", image.denoised}, {"reference", reference.denoised}}},
          {"largest", d.largest}};
}

std::string textOf(const ImageDifference& d, double flip) {
  return fmt::format(
      "mean ratio  {:.5f} {:.5f} {:.5f}\n"
      "MSE         {:.6g}\n"
      "relMSE      {:.6g}\n"
      "noise       {}\n"
      "PSNR        {:.2f} dB\n"
      "FLIP        {:.4f}\n"
      "largest     {:.6g}\n",
      d.mean_ratio.x, d.mean_ratio.y, d.mean_ratio.z, d.mse, d.relative_mse, percent(d.noise),
      d.psnr, flip, d.largest);
}

// Which of them have been denoised: a difference is then no measure of noise.
std::string denoisedText(const Image& image, const Image& reference) {
  if (!image.denoised && !reference.denoised) return "";
  const char* const which = image.denoised
                                ? (reference.denoised ? "both pictures" : "the first picture")
                                : "the second picture";
  return fmt::format("denoised    {}\n", which);
}

double valueOf(const std::string& metric, const ImageDifference& d, double flip) {
  if (metric == "relmse") return d.relative_mse;
  if (metric == "mse") return d.mse;
  return metric == "noise" ? d.noise : flip;
}

void checkOutput(const CompareOptions& options) {
  checkJsonFile(options.json);
  if (options.output.empty()) return;
  if (imageFormatOf(options.output) != ImageFormat::png)
    throw Error(ErrorKind::usage, "the difference is written as a .png; name one with -o");
  checkWritable(options.output);
}

}  // namespace

// Linear pictures are looked at as a display shows them.
int runCompare(const CompareOptions& options) {
  checkOutput(options);
  const Image image = readImage(options.image);
  const Image reference = readImage(options.reference);
  const ImageDifference difference = differenceOf(image, reference);
  const FlipDifference flip = flipOf(displayImage(image, 0), displayImage(reference, 0));
  if (!options.output.empty())
    writeDisplayImage(options.output, flipPicture(flip, image.width, image.height));
  if (options.json.empty()) {
    writeOut(textOf(difference, flip.mean) + denoisedText(image, reference));
  } else {
    writeJson(options.json, reportOf(options, image, reference, difference, flip.mean));
  }
  const double value = valueOf(options.metric, difference, flip.mean);
  if (!options.threshold || value <= *options.threshold) return 0;
  say(fmt::format("{} is {:.4g}, above the threshold of {:.4g}", options.metric, value,
                  *options.threshold));
  return 1;
}

}  // namespace glimt
