#include "app/picture_files.h"

#include "renderer/core/display_transform.h"
#include "renderer/core/image_file.h"

namespace glimt {

void writePicture(const std::filesystem::path& file, const Image& radiance, float exposure,
                  Tone tone) {
  if (imageFormatOf(file) == ImageFormat::png)
    writeDisplayImage(file, displayImage(radiance, exposure, tone));
  else
    writeImage(file, radiance);
}

}  // namespace glimt
