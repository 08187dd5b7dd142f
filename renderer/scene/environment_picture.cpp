#include "renderer/scene/environment_picture.h"

#include <fmt/format.h>

#include <cmath>

#include "renderer/core/error.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"
#include "renderer/scene/studio.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

// What is not a radiance becomes black. True when there was such a pixel.
bool makeSound(Image& image) {
  bool changed = false;
  for (Vec3& pixel : image.pixels)
    for (int c = 0; c < 3; ++c) {
      if (pixel[c] >= 0 && std::isfinite(pixel[c])) continue;
      pixel[c] = 0;
      changed = true;
    }
  return changed;
}

Image readSky(const fs::path& path) {
  try {
    return readImage(path);
  } catch (const Error& error) {
    // Whatever is wrong with it, it is the scene that cannot be used.
    throw Error(ErrorKind::input, error.what());
  }
}

}  // namespace

Image environmentPicture(const std::string& name, const fs::path& folder, const SunSky& sun_sky,
                         std::vector<std::string>& warnings) {
  if (name == kStudioName) return makeStudio();
  if (name == kSunSkyName) return makeSunSky(sun_sky);
  const fs::path path = folder / fs::path(name);
  Image image = readSky(path);
  if (makeSound(image))
    warnings.push_back(
        fmt::format("environment {}: pixels that are negative or not finite are black",
                    printable(path.filename().string())));
  return image;
}

}  // namespace glimt
