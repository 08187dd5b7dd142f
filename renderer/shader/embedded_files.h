// The files of shaders/, inside the executable. Generated at build time by embed.cmake.
#pragma once

#include <vector>

namespace glimt {

struct EmbeddedFile {
  const char* name;
  const char* text;
};

const std::vector<EmbeddedFile>& embeddedFiles();

}  // namespace glimt
