// The picture of an environment: from a file, or one of those that are built in.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/core/image.h"
#include "renderer/scene/sun_sky.h"

namespace glimt {

inline constexpr const char* kStudioName = "studio";
inline constexpr const char* kSunSkyName = "sun-sky";

// `name` is one of those above, or a file relative to `folder`. What is not a radiance in a file
// becomes black, and a warning is added. Errors: input, from reading the file.
Image environmentPicture(const std::string& name, const std::filesystem::path& folder,
                         const SunSky& sun_sky, std::vector<std::string>& warnings);

}  // namespace glimt
