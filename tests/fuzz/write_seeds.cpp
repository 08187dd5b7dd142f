// Writes good files for the fuzzers to begin with, a folder a kind. usage: fuzz_seeds FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/hostile/good_files.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: fuzz_seeds FOLDER\n", stderr);
    return 2;
  }
  for (const glimt::GoodFile& file : glimt::goodFiles()) {
    const std::filesystem::path folder = std::filesystem::path(argv[1]) / file.kind;
    std::filesystem::create_directories(folder);
    std::ofstream(folder / file.name, std::ios::binary) << file.bytes;
  }
}
