#pragma once

#include <filesystem>

namespace glimt {

// Finds out before the work, not after it, that a file cannot be written: its folder is missing or
// protected, or it is a folder itself. Errors: usage.
void checkWritable(const std::filesystem::path& file);

// Where pictures are denoised their files have to say so. Errors: usage, for those that cannot.
void checkCanTellDenoised(const std::filesystem::path& file);

// With those above it, where they are not there. Errors: failed.
void makeFolder(const std::filesystem::path& folder);

}  // namespace glimt
