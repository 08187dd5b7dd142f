#pragma once

#include <filesystem>

namespace glimt {

// The scene that comes with glimt, found from where the program lies: in a build folder of the
// source tree, or installed. Errors: usage, when it is not there.
std::filesystem::path defaultScene();

}  // namespace glimt
