// Files that other files name.
#pragma once

#include <filesystem>
#include <string>

namespace glimt {

// The file that a model in `folder` means: relative to it, whichever way its slashes lean, or just
// beside the model when it stood somewhere else where that was made. Empty when there is none.
std::filesystem::path pathBeside(const std::filesystem::path& folder, std::string name);

}  // namespace glimt
