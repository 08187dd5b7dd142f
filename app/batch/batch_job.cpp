#include "app/batch/batch_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "renderer/core/error.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"
#include "renderer/scene/json_fields.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 8;
constexpr double kLargestFloat = std::numeric_limits<float>::max();

constexpr Range kSide = {1, 16384, "an integer between 1 and 16384"};
constexpr Range kAngles = {1, kMostAngles, "an integer between 1 and 100000"};
constexpr Range kDegrees = {-kLargestFloat, kLargestFloat, "a number of degrees"};
constexpr Range kElevation = {-89, 89, "a number of degrees between -89 and 89"};
constexpr Range kSamples = {1, std::numeric_limits<int>::max(), "an integer above 0"};
constexpr Range kSeconds = {0, 1e9, "a number of seconds above 0 and below 1e9", true};
constexpr Range kPercent = {0.001, 100, "percent from 0.001 to 100"};
constexpr Range kBounces = {0, kMostBounces, "an integer between 0 and 64"};
constexpr Range kExposure = {-64, 64, "a number between -64 and 64"};
constexpr Range kSeed = {0, std::numeric_limits<int>::max(), "an integer from 0 to 2147483647"};
constexpr Range kLuminance = {0, 1e9, "a number above 0 and below 1e9", true};
constexpr Range kStrength = {0, 1e9, "a number between 0 and 1e9"};
constexpr Range kGles = {2, 3, "2 or 3"};

// One of `choices`.
std::optional<std::string> choice(const JsonFields& fields, const char* key,
                                  const std::vector<std::string>& choices) {
  const std::optional<std::string> text = fields.text(key);
  if (text && std::find(choices.begin(), choices.end(), *text) == choices.end())
    fields.reject(key, "one of " + listed(choices));
  return text;
}

// An array of different texts, at least one.
std::vector<std::string> texts(const JsonFields& fields, const char* key) {
  const nlohmann::json* const array = fields.array(key);
  if (array == nullptr) return {};
  std::vector<std::string> out;
  std::set<std::string> seen;
  for (const nlohmann::json& value : *array) {
    if (!value.is_string() || value.get_ref<const std::string&>().empty() ||
        !seen.insert(value.get<std::string>()).second)
      fields.reject(key, "an array of different texts");
    out.push_back(value.get<std::string>());
  }
  if (out.empty()) fields.reject(key, "an array of at least one text");
  return out;
}

std::vector<std::array<int, 2>> sizes(const JsonFields& fields, const char* key) {
  const nlohmann::json* const array = fields.array(key);
  if (array == nullptr) return {};
  std::vector<std::array<int, 2>> out;
  const auto fits = [](const nlohmann::json& side) {
    return side.is_number_integer() && side >= kSide.low && side <= kSide.high;
  };
  for (const nlohmann::json& size : *array) {
    if (!size.is_array() || size.size() != 2 || !fits(size[0]) || !fits(size[1]))
      fields.reject(key, "an array of [width, height], each an integer from 1 to 16384");
    out.push_back({size[0].get<int>(), size[1].get<int>()});
  }
  if (out.empty()) fields.reject(key, "an array of at least one size");
  return out;
}

void readVariants(const JsonFields& fields, const nlohmann::json& file, BatchJob& job) {
  if (!fields.has("variants")) return;
  job.all_variants = file["variants"] == "all";
  if (job.all_variants) return;
  if (!file["variants"].is_array()) fields.reject("variants", "\"all\" or an array of names");
  job.variants = texts(fields, "variants");
}

std::optional<Turntable> readTurntable(const JsonDocument& document, const JsonFields& job) {
  const nlohmann::json* const value = job.object("turntable");
  if (value == nullptr) return {};
  const JsonFields fields(document, "turntable", *value, {"angles", "start", "elevation"});
  Turntable turntable;
  turntable.angles = fields.integer("angles", kAngles).value_or(turntable.angles);
  turntable.start = fields.number("start", kDegrees).value_or(0.0f);
  turntable.elevation = fields.number("elevation", kElevation);
  return turntable;
}

// As the options of glimt render that have the same names.
PictureOptions readPicture(const JsonFields& fields) {
  PictureOptions picture;
  picture.environment.image = fields.text("environment");
  picture.environment.rotation = fields.number("environment_rotation", kDegrees);
  picture.environment.strength = fields.number("environment_strength", kStrength);
  picture.bounces = fields.integer("bounces", kBounces);
  picture.exposure = fields.number("exposure", kExposure);
  if (const auto tone = choice(fields, "tone", {kToneNames.begin(), kToneNames.end()}))
    picture.tone = toneNamed(*tone);
  if (const auto background = choice(fields, "background", {"scene", "transparent"}))
    picture.transparent_background = background == "transparent";
  picture.seed = static_cast<std::uint32_t>(fields.integer("seed", kSeed).value_or(0));
  picture.traversal = fields.text("traversal").value_or(picture.traversal);
  picture.record = choice(fields, "record", {"packed", "wide"}).value_or(picture.record);
  if (choice(fields, "sampler", {"sobol", "random"}) == "random") picture.sampler = Sampler::random;
  picture.roulette = choice(fields, "roulette", {"on", "off"}) != "off";
  picture.clamp = fields.number("clamp", kLuminance);
  picture.gles = fields.integer("gles", kGles).value_or(picture.gles);
  return picture;
}

Limits readLimits(const JsonFields& fields) {
  Limits limits;
  limits.samples = fields.integer("spp", kSamples);
  limits.seconds = fields.number("time", kSeconds);
  if (const auto percent = fields.number("noise", kPercent))
    limits.noise = 0.01 * static_cast<double>(*percent);
  return orDefault(limits);
}

Backend readBackend(const JsonFields& fields) {
  const auto name = choice(fields, "backend", {"auto", "egl", "osmesa"});
  if (name == "egl") return Backend::egl;
  return name == "osmesa" ? Backend::osmesa : Backend::automatic;
}

void readFormats(const JsonFields& fields, BatchJob& job) {
  if (!fields.has("formats")) return;
  job.formats = texts(fields, "formats");
  for (const std::string& format : job.formats)
    if (format != "png" && format != "exr" && format != "pfm" && format != "hdr")
      fields.reject("formats", "an array of png, exr, pfm or hdr");
}

}  // namespace

BatchJob readBatchJob(const fs::path& path) {
  const JsonDocument document = readJson(path, kDeepest);
  const JsonFields fields(document, "", document.value,
                          {"scene",
                           "output",
                           "formats",
                           "variants",
                           "cameras",
                           "turntable",
                           "sizes",
                           "spp",
                           "time",
                           "noise",
                           "even",
                           "denoise",
                           "environment",
                           "environment_rotation",
                           "environment_strength",
                           "bounces",
                           "exposure",
                           "tone",
                           "background",
                           "seed",
                           "traversal",
                           "record",
                           "sampler",
                           "roulette",
                           "clamp",
                           "gles",
                           "backend"});
  const std::optional<std::string> scene = fields.text("scene");
  if (!scene)
    throw Error(ErrorKind::input,
                fmt::format("{}: the key \"scene\" is missing; name the scene file or the model",
                            printable(path.string())));
  BatchJob job;
  job.file = path;
  job.scene = path.parent_path() / *scene;
  job.folder = path.parent_path() / fields.text("output").value_or(path.stem().string());
  readFormats(fields, job);
  readVariants(fields, document.value, job);
  job.cameras = texts(fields, "cameras");
  job.turntable = readTurntable(document, fields);
  job.sizes = sizes(fields, "sizes");
  job.picture = readPicture(fields);
  job.limits = readLimits(fields);
  job.even = fields.boolean("even").value_or(false);
  job.denoise = fields.boolean("denoise").value_or(false);
  if (job.denoise && std::count(job.formats.begin(), job.formats.end(), "pfm") > 0)
    fields.reject("denoise", "false where a format is pfm, which cannot tell of it");
  job.backend = readBackend(fields);
  if (auto& image = job.picture.environment.image;
      image && *image != "studio" && *image != "sun-sky")
    image = (path.parent_path() / *image).string();
  return job;
}

}  // namespace glimt
