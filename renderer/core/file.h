// Whole files, in and out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace glimt {

// The bytes of a regular file of at most `largest` bytes.
// Errors: input, "PATH: cannot read (why); what to do".
std::string readFile(const std::filesystem::path& path, std::uintmax_t largest);

// The file appears complete or not at all: the bytes go into a temporary beside it, which then
// takes its name. What is no regular file (a pipe, /dev/stdout) is written to directly.
// Errors: failed, "PATH: cannot write (why); what to do".
void writeFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace glimt
