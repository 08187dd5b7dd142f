#include "app/batch/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kLargestManifest = 256 << 20;
constexpr const char* kName = "manifest.json";
constexpr const char* kPartPrefix = "manifest-part-";

double rounded(double value, double steps) {
  return std::round(value * steps) / steps;
}

Json jsonOf(const ManifestEntry& entry) {
  Json json = {{"file", entry.file}};
  if (!entry.variant.empty()) json["variant"] = entry.variant;
  if (!entry.camera.empty()) json["camera"] = entry.camera;
  if (entry.angle) json["angle"] = *entry.angle;
  json["size"] = entry.size;
  json["samples"] = entry.samples;
  json["noise"] = entry.noise ? Json(rounded(*entry.noise, 1e6)) : Json();
  if (entry.denoised) json["denoised"] = true;
  json["seconds"] = rounded(entry.seconds, 1e3);
  json["sha256"] = entry.sha256;
  json["inputs"] = entry.inputs;
  return json;
}

ManifestEntry entryOf(const Json& json) {
  ManifestEntry entry;
  entry.file = json.at("file");
  entry.variant = json.value("variant", "");
  entry.camera = json.value("camera", "");
  if (json.contains("angle")) entry.angle = json.at("angle").get<double>();
  entry.size = json.at("size");
  entry.samples = json.at("samples");
  if (!json.at("noise").is_null()) entry.noise = json.at("noise").get<double>();
  entry.denoised = json.value("denoised", false);
  entry.seconds = json.at("seconds");
  entry.sha256 = json.at("sha256");
  entry.inputs = json.at("inputs");
  return entry;
}

void readInto(Manifest& manifest, const fs::path& path) {
  try {
    const Json json = Json::parse(readFile(path, kLargestManifest));
    for (const Json& entry : json.at("pictures")) manifest.add(entryOf(entry));
  } catch (const Json::exception&) {
    throw Error(ErrorKind::input,
                fmt::format("{}: no manifest of glimt batch; remove it, and what it says of the "
                            "pictures there is made again",
                            printable(path.string())));
  }
}

std::vector<fs::path> partManifests(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().filename().string().starts_with(kPartPrefix)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

template <typename Item>
void replace(std::vector<Item>& items, const Item& item) {
  const auto place = std::lower_bound(items.begin(), items.end(), item,
                                      [](const Item& a, const Item& b) { return a.file < b.file; });
  if (place != items.end() && place->file == item.file)
    *place = item;
  else
    items.insert(place, item);
}

template <typename Item>
void forget(std::vector<Item>& items, const std::string& file) {
  std::erase_if(items, [&](const Item& item) { return item.file == file; });
}

}  // namespace

const ManifestEntry* Manifest::find(const std::string& file) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const ManifestEntry& entry) { return entry.file == file; });
  return found == entries_.end() ? nullptr : &*found;
}

void Manifest::add(const ManifestEntry& entry) {
  replace(entries_, entry);
  forget(failures_, entry.file);
}

void Manifest::add(const ManifestFailure& failure) {
  replace(failures_, failure);
  forget(entries_, failure.file);
}

void Manifest::keepOnly(const std::vector<std::string>& files) {
  const auto other = [&](const auto& item) {
    return std::find(files.begin(), files.end(), item.file) == files.end();
  };
  std::erase_if(entries_, other);
  std::erase_if(failures_, other);
}

std::string manifestName(int part, int parts) {
  return parts == 1 ? kName : fmt::format("{}{}-of-{}.json", kPartPrefix, part, parts);
}

Manifest readManifests(const fs::path& folder) {
  Manifest manifest;
  std::error_code ignored;
  if (fs::exists(folder / kName, ignored)) readInto(manifest, folder / kName);
  for (const fs::path& path : partManifests(folder)) readInto(manifest, path);
  return manifest;
}

void writeManifest(const fs::path& file, const Manifest& manifest) {
  Json json = {{"pictures", Json::array()}, {"failed", Json::array()}};
  for (const ManifestEntry& entry : manifest.entries()) json["pictures"].push_back(jsonOf(entry));
  for (const ManifestFailure& failure : manifest.failures())
    json["failed"].push_back({{"file", failure.file}, {"error", failure.error}});
  writeFile(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void removePartManifests(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::path& path : partManifests(folder)) fs::remove(path, ignored);
}

}  // namespace glimt
