// The picture in the window as a command.
#pragma once

#include <array>
#include <string>

#include "app/viewer/loaded_scene.h"
#include "app/viewer/look.h"

namespace glimt {

// `glimt render` of the file that is open, for a POSIX shell, to so many samples. The look and the
// camera are such that fitsCommandLine().
std::string renderCommandLine(const LoadedScene& loaded, const Look& look, const Camera& camera,
                              std::array<int, 2> size, int samples);

// The same of a scene file that holds the look and the camera.
std::string renderCommandLine(const std::filesystem::path& scene, int samples);

// One word for a POSIX shell.
std::string shellWord(const std::string& text);

}  // namespace glimt
