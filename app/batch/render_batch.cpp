#include "app/batch/render_batch.h"

#include "renderer/core/error.h"
#include "renderer/core/image_file.h"

namespace glimt {

BatchJob batchJobOf(const RenderOptions& options) {
  if (options.outputs.size() != 1 || isImageFile(options.outputs.front()))
    throw Error(ErrorKind::usage,
                "--variants and --turntable make several pictures; name one folder for them, like "
                "-o pictures");
  BatchJob job;
  job.file = job.scene = options.scene;
  job.folder = options.outputs.front();
  job.all_variants = options.variants == std::vector<std::string>{"all"};
  if (!job.all_variants) job.variants = options.variants;
  if (job.variants.empty() && !job.all_variants && !options.load.variant.empty())
    job.variants = {options.load.variant};
  if (options.angles) job.turntable = Turntable{*options.angles, 0, {}};
  if (options.picture.size) job.sizes = {*options.picture.size};
  job.picture = options.picture;
  job.limits = orDefault({options.samples, options.seconds, options.noise});
  job.even = options.even;
  job.denoise = options.denoise;
  job.backend = options.backend;
  return job;
}

}  // namespace glimt
