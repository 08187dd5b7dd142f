#pragma once

#include <filesystem>
#include <string>

namespace glimt {

// NAME.png in the current folder, or where that is taken NAME-2.png, NAME-3.png and so on.
std::filesystem::path snapshotName(const std::string& name);

}  // namespace glimt
