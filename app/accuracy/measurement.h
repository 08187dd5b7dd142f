// Renders a reference and every variant, and keeps what is done, so that it need not be done again.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/accuracy/curve.h"
#include "app/accuracy/variants.h"
#include "renderer/limit_error.h"

namespace glimt {

struct AccuracyPlan {
  std::vector<AccuracyVariant> variants;  // the first one is as asked for
  Backend backend = Backend::automatic;
  std::filesystem::path folder;  // where the pieces are kept
  std::optional<std::filesystem::path>
      reference;         // a picture to compare with, of the variants' size
  double seconds = 150;  // for all of it, about
  Json key;              // what the pieces depend on; those of another key are done again
};

// The parts of the error of the picture as asked for, at its last point.
struct ErrorBudget {
  int samples = 0;
  double noise = 0;       // estimated without the reference
  double truncation = 0;  // see LimitError
  double clamp = 0;
  double limits = 0;    // both together
  double measured = 0;  // against the reference
  int enough_bounces = 0;
};

struct AccuracyResult {
  ContextInfo context;
  int reference_samples = 0;   // 0 where the reference is the user's
  double reference_noise = 0;  // what it is wrong by itself
  int reference_bounces = 0;
  std::vector<AccuracyCurve> curves;
  ErrorBudget budget;
};

// In the plan's folder.
inline constexpr const char* kReferencePicture = "reference.pfm";

// Told what is done next, and the share that is done.
using AccuracyProgress = std::function<void(const std::string& what, double share)>;

// Files in the plan's folder: the reference, and for each variant its curve and its last picture,
// and of the first also the pictures of its first samples, see pictureFile(). `progress` may throw
// to end it; what is complete is kept. Errors: input for a reference of another size, failed, and
// those of the renderer.
AccuracyResult measureAccuracy(const AccuracyPlan& plan, const Scene& scene,
                               const AccuracyProgress& progress);

Json jsonOf(const ErrorBudget& budget);

// Of a variant's picture after so many samples, in the folder.
std::string pictureFile(const std::string& variant, int samples);

}  // namespace glimt
