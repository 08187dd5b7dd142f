// Typed, checked reading of JSON objects: what is not as it should be is an Error that names the
// key, as in "camera.vertical_fov must be a number between 0 and 180, not "wide"".
#pragma once

#include <array>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <unordered_map>

#include "renderer/core/vector.h"

namespace glimt {

struct JsonDocument {
  std::filesystem::path path;
  nlohmann::json value;
  std::unordered_map<std::string, std::size_t> lines;  // of each key, by its name "camera.up"
};

// Errors: input, with the line of a syntax error. Nesting deeper than `deepest` is an error too.
JsonDocument readJson(const std::filesystem::path& path, int deepest);

// Which numbers are allowed, and how a message says so.
struct Range {
  double low;
  double high;
  const char* words;  // "a number between 0 and 180"
  bool open = false;  // low and high themselves are not allowed
};

// One JSON object. All functions return nothing for a key that is not there, and throw Error input
// for a value of another type or out of range.
class JsonFields {
 public:
  // `name` is where the object stands in the file, "" for the file itself. The object may have the
  // keys in `known` only. Keeps references to `document` and `value`.
  JsonFields(const JsonDocument& document, std::string name, const nlohmann::json& value,
             std::initializer_list<const char*> known);

  bool has(const char* key) const { return object_.contains(key); }
  std::optional<float> number(const char* key, const Range& range) const;
  std::optional<int> integer(const char* key, const Range& range) const;
  std::optional<bool> boolean(const char* key) const;
  std::optional<std::string> text(const char* key) const;
  std::optional<Vec3> vector(const char* key, const Range& each) const;
  std::optional<glm::dvec3> point(const char* key, const Range& each) const;
  std::optional<std::array<int, 2>> integers(const char* key, const Range& each) const;
  const nlohmann::json* object(const char* key) const;
  const nlohmann::json* array(const char* key) const;

  std::string nameOf(const char* key) const;

  // "PATH:LINE: camera.up must be WHAT, not VALUE".
  [[noreturn]] void reject(const char* key, const std::string& what) const;

 private:
  const nlohmann::json* find(const char* key) const;

  const JsonDocument& document_;
  std::string name_;
  const nlohmann::json& object_;
};

}  // namespace glimt
