#include "app/batch/batch_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "renderer/core/error.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

struct View {
  std::string name;
  std::string camera;
  std::optional<double> angle;
};

// Fit for any file system and for a URL.
std::string fileNameOf(const std::string& name) {
  constexpr std::string_view kKept =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-";
  std::string out;
  for (const char c : name) out += kKept.find(c) == std::string_view::npos ? '-' : c;
  return out;
}

std::vector<View> viewsOf(const BatchJob& job) {
  std::vector<View> views;
  for (const std::string& camera : job.cameras) views.push_back({fileNameOf(camera), camera, {}});
  if (job.turntable) {
    const Turntable& turntable = *job.turntable;
    for (int i = 0; i < turntable.angles; ++i) {
      const double around = turntable.start + 360.0 * i / turntable.angles;
      const double angle = around - 360 * std::floor(around / 360);
      const bool whole = angle == std::round(angle);
      views.push_back(
          {whole ? fmt::format("{:03.0f}", angle) : fmt::format("{:07.3f}", angle), "", angle});
    }
  }
  if (views.empty()) views.emplace_back();
  return views;
}

std::string stemOf(const BatchJob& job, const BatchPicture& picture, const View& view) {
  const std::string variant = picture.variant.empty() ? fileNameOf(job.scene.stem().stem().string())
                                                      : fileNameOf(picture.variant);
  const std::string between = view.name.empty() ? "" : "_" + view.name;
  return fmt::format("{}{}_{}x{}", variant, between, picture.size[0], picture.size[1]);
}

void demandKnown(const BatchJob& job, const std::string& what,
                 const std::vector<std::string>& names, const std::vector<std::string>& known) {
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(
          ErrorKind::input,
          fmt::format("{}: the scene has no {} '{}'; {}", printable(job.file.string()), what,
                      printable(name), known.empty() ? "it has none" : "it has " + listed(known)));
}

void demandDifferentNames(const BatchJob& job, const std::vector<BatchPicture>& plan) {
  std::set<std::string> names;
  for (const BatchPicture& picture : plan)
    if (!names.insert(picture.stem).second)
      throw Error(ErrorKind::input,
                  fmt::format("{}: two pictures would be called {}; give the variants or cameras "
                              "names that differ in their letters and digits",
                              printable(job.file.string()), picture.stem));
}

glm::dvec3 aroundY(const glm::dvec3& v, double turn) {
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

// Unit and level, from the target to where the camera stands; from straight above that is where the
// picture's lower edge is.
glm::dvec3 frontOf(const Camera& camera) {
  glm::dvec3 front = glm::dvec3(camera.position) - glm::dvec3(camera.target);
  const double distance = glm::length(front);
  front.y = 0;
  if (glm::length(front) > 1e-6 * distance) return glm::normalize(front);
  const glm::dvec3 below(-camera.up.x, 0, -camera.up.z);
  return glm::normalize(below);
}

glm::dvec3 raised(const glm::dvec3& front, double elevation) {
  return front * std::cos(elevation) + glm::dvec3(0, std::sin(elevation), 0);
}

}  // namespace

std::vector<BatchPicture> planOf(const BatchJob& job, const Scene& scene) {
  std::vector<std::string> cameras;
  for (const NamedCamera& camera : scene.cameras) cameras.push_back(camera.name);
  demandKnown(job, "variant", job.variants, scene.variants);
  demandKnown(job, "camera", job.cameras, cameras);
  std::vector<std::string> variants = job.all_variants ? scene.variants : job.variants;
  if (variants.empty()) variants.emplace_back();
  std::vector<std::array<int, 2>> sizes = job.sizes;
  if (sizes.empty()) sizes.push_back(scene.render.size.value_or(std::array{512, 512}));
  std::vector<BatchPicture> plan;
  for (const std::string& variant : variants) {
    for (const View& view : viewsOf(job)) {
      for (const std::array<int, 2>& size : sizes) {
        BatchPicture picture{"", variant, view.camera, view.angle, size};
        picture.stem = stemOf(job, picture, view);
        plan.push_back(picture);
      }
    }
  }
  demandDifferentNames(job, plan);
  return plan;
}

std::vector<BatchPicture> partOf(const std::vector<BatchPicture>& plan, int part, int parts) {
  const auto size = static_cast<std::ptrdiff_t>(plan.size());
  return {plan.begin() + size * (part - 1) / parts, plan.begin() + size * part / parts};
}

Camera turned(const Camera& camera, double angle, const std::optional<float>& elevation) {
  const glm::dvec3 target(camera.target);
  glm::dvec3 arm = glm::dvec3(camera.position) - target;
  Camera moved = camera;
  if (elevation) {
    arm = glm::length(arm) * raised(frontOf(camera), glm::radians(double{*elevation}));
    moved.up = Vec3(0, 1, 0);
  }
  const double turn = glm::radians(angle);
  moved.position = Vec3(target + aroundY(arm, turn));
  moved.up = Vec3(aroundY(glm::dvec3(moved.up), turn));
  return moved;
}

}  // namespace glimt
