#include "app/viewer/render_command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <system_error>

namespace glimt {
namespace {

namespace fs = std::filesystem;

// Of doubles, so that a model far from its file's origin does not lose its place.
std::string wordOf(const glm::dvec3& v) {
  return fmt::format("{:.9g},{:.9g},{:.9g}", v.x, v.y, v.z);
}

std::string fullName(const fs::path& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal().string();
}

// A scene file's name may end in .scene.json.
std::string outputOf(const fs::path& scene) {
  return shellWord(scene.stem().stem().string() + ".png");
}

}  // namespace

std::string shellWord(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("-_./,+:=@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string renderCommandLine(const LoadedScene& loaded, const Look& look, const Camera& camera,
                              std::array<int, 2> size, int samples) {
  const Scene& scene = loaded.scene;
  const auto place = [&](const Vec3& p) { return wordOf(scene.origin + glm::dvec3(p)); };
  std::string line = "glimt render " + shellWord(fullName(loaded.choice.path));
  const auto add = [&line](const std::string& option, const std::string& value) {
    line += fmt::format(" {}={}", option, shellWord(value));
  };
  if (!look.variant.empty()) add("--variant", look.variant);
  add("--eye", place(camera.position));
  add("--target", place(camera.target));
  add("--up", wordOf(glm::dvec3(camera.up)));
  add("--fov", fmt::format("{}", camera.vertical_fov));
  if (const auto& image = loaded.choice.settings.environment.image) add("--environment", *image);
  if (look.environment_strength != scene.environment.strength ||
      loaded.choice.settings.environment.strength)
    add("--environment-strength", fmt::format("{}", look.environment_strength));
  if (look.environment_rotation != scene.environment.rotation ||
      loaded.choice.settings.environment.rotation)
    add("--environment-rotation", fmt::format("{}", look.environment_rotation));
  add("--bounces", fmt::format("{}", look.bounces));
  add("--exposure", fmt::format("{}", look.exposure));
  add("--tone", kToneNames[static_cast<std::size_t>(look.tone)]);
  add("--size", fmt::format("{}x{}", size[0], size[1]));
  add("--spp", fmt::format("{}", samples));
  return line + " -o " + outputOf(loaded.choice.path);
}

std::string renderCommandLine(const fs::path& scene, int samples) {
  return fmt::format("glimt render {} --spp {} -o {}", shellWord(fullName(scene)), samples,
                     outputOf(scene));
}

}  // namespace glimt
