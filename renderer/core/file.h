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

// The file that is written when `path` is: through links, also where the last one names nothing
// yet.
std::filesystem::path outputTarget(const std::filesystem::path& path);

// The file appears complete or not at all: the bytes go into a temporary beside it, which then
// takes its name; SIGINT and SIGTERM wait until that is done. It keeps the permissions of the file
// that it replaces. What is no regular file (a pipe, /dev/stdout) is written to directly.
// Errors: failed, "PATH: cannot write (why); what to do".
void writeFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace glimt
