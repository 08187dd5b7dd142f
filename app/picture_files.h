#pragma once

#include <filesystem>

#include "renderer/core/image.h"
#include "renderer/core/tone.h"

namespace glimt {

// A rendered picture in the format of the file's name: as a display shows it in a .png, else
// linear. The file appears complete or not at all. Errors: usage, for a name of no such format;
// failed.
void writePicture(const std::filesystem::path& file, const Image& radiance, float exposure,
                  Tone tone);

}  // namespace glimt
