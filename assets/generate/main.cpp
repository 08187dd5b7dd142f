// Writes the demo scenes: make_assets FOLDER [NAME]...
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "assets/generate/demos.h"
#include "renderer/core/error.h"

namespace {

using namespace glimt::assets;

void writeDemos(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  std::filesystem::create_directories(folder);
  for (const std::string& name : names) {
    const auto make = demos().find(name);
    if (make == demos().end())
      throw glimt::Error(glimt::ErrorKind::usage,
                         fmt::format("there is no demo '{}'; without names all are written", name));
    writeDemo(folder, make->second());
  }
}

std::vector<std::string> allNames() {
  std::vector<std::string> names;
  for (const auto& [name, make] : demos()) names.push_back(name);
  return names;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: make_assets FOLDER [NAME]...\n", stderr);
    return static_cast<int>(glimt::ErrorKind::usage);
  }
  try {
    const std::vector<std::string> names(argv + 2, argv + argc);
    writeDemos(argv[1], names.empty() ? allNames() : names);
  } catch (const glimt::Error& error) {
    std::fprintf(stderr, "make_assets: %s\n", error.what());
    return static_cast<int>(error.kind());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_assets: %s\n", error.what());
    return static_cast<int>(glimt::ErrorKind::failed);
  }
  return 0;
}
