// What a job file asks for: docs/batch.md.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/picture_settings.h"
#include "app/sampling.h"

namespace glimt {

inline constexpr int kMostAngles = 100'000;

// A camera that goes around its target.
struct Turntable {
  int angles = 12;                 // evenly spaced, from `start` on
  double start = 0;                // degrees, counter-clockwise seen from above
  std::optional<float> elevation;  // degrees above the target; none: the camera's own
};

struct BatchJob {
  std::filesystem::path file;
  std::filesystem::path scene;
  std::filesystem::path folder;             // of the pictures
  std::vector<std::string> formats{"png"};  // extensions, without the dot
  bool all_variants = false;                // of those that the scene has
  std::vector<std::string> variants;        // else these; none: the scene as it is
  std::vector<std::string> cameras;         // of the scene
  std::optional<Turntable> turntable;       // neither: the scene's camera
  std::vector<std::array<int, 2>> sizes;    // none: the scene's, else 512x512
  PictureOptions picture;                   // but for its size; `cameras` name others
  Limits limits;
  bool even = false;  // every pixel has all samples, also with a limit on the noise
  bool denoise = false;
  Backend backend = Backend::automatic;
};

// Relative paths in the file start at its folder. Errors: input, naming the line and the key.
BatchJob readBatchJob(const std::filesystem::path& path);

}  // namespace glimt
