#include "renderer/scene/json_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

using nlohmann::json;

// A scene file holds names and numbers, no geometry.
constexpr std::uintmax_t kLargestSceneFile = 16 << 20;

// The parser looks at all objects before whenever one ends, so its time grows with their square.
constexpr std::size_t kMostKeys = 20'000;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw Error(ErrorKind::input, fmt::format("{}: {}", printable(file.string()), what));
}

[[noreturn]] void fail(const std::filesystem::path& file, std::size_t line,
                       const std::string& what) {
  throw Error(ErrorKind::input, fmt::format("{}:{}: {}", printable(file.string()), line, what));
}

// With the line of the key that stands there, or of the array that it is in; what has no key of its
// own has no line.
[[noreturn]] void fail(const JsonDocument& document, const std::string& key,
                       const std::string& what) {
  const auto line = document.lines.find(key.substr(0, key.find('[')));
  if (line == document.lines.end()) fail(document.path, what);
  fail(document.path, line->second, what);
}

std::string nameWithin(const std::string& name, const std::string& key) {
  return name.empty() ? key : fmt::format("{}.{}", name, key);
}

// Hands out the text, and counts its lines on the way: the parser tells of keys while it reads.
class LineCounter {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  LineCounter(const char* at, std::size_t* line) : at_(at), line_(line) {}

  reference operator*() const { return *at_; }
  LineCounter& operator++() {
    if (*at_++ == '\n') ++*line_;
    return *this;
  }
  bool operator==(const LineCounter& other) const { return at_ == other.at_; }
  bool operator!=(const LineCounter& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* line_;
};

std::size_t lineOf(std::string_view bytes, std::size_t position) {
  const std::string_view before = bytes.substr(0, position == 0 ? 0 : position - 1);
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

// The part of nlohmann's message that says what it found, without its codes and positions.
std::string reasonIn(std::string_view message) {
  const std::size_t start = message.rfind("; expected");
  const std::size_t found = message.find(" - ");
  if (found == std::string_view::npos) return "syntax error";
  return printable(message.substr(found + 3, start == std::string_view::npos || start < found
                                                 ? std::string_view::npos
                                                 : start - found - 3));
}

std::string described(const json& value) {
  switch (value.type()) {
    case json::value_t::object:
      return "an object";
    case json::value_t::array:
      return fmt::format("an array of {}", grouped(value.size()));
    case json::value_t::string:
      return fmt::format(
          "\"{}\"", printable(std::string_view(value.get_ref<const std::string&>()).substr(0, 60)));
    default:
      return value.dump();
  }
}

bool inRange(const json& value, const Range& range) {
  if (!value.is_number()) return false;
  // The rounded value is the one that is used, so it is the one to be checked.
  const double number = static_cast<double>(value.get<float>());
  if (!std::isfinite(number)) return false;
  return range.open ? number > range.low && number < range.high
                    : number >= range.low && number <= range.high;
}

bool isInteger(const json& value, const Range& range) {
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  return number == std::floor(number) && number >= range.low && number <= range.high;
}

}  // namespace

JsonDocument readJson(const std::filesystem::path& path, int deepest) {
  const std::string bytes = readFile(path, kLargestSceneFile);
  JsonDocument document{path, {}, {}};
  std::size_t line = 1;
  std::size_t keys = 0;
  std::vector<std::string> names = {""};  // of the objects around, outermost first
  const auto follow = [&](int depth, json::parse_event_t event, json& parsed) {
    if (depth > deepest) {
      fail(path, line, "nested too deeply; a scene file has objects in one object");
    }
    if (event != json::parse_event_t::key) return true;
    if (++keys > kMostKeys) {
      fail(path, line, fmt::format("more than {} keys; set fewer materials", grouped(kMostKeys)));
    }
    names.resize(static_cast<std::size_t>(depth));
    names.push_back(nameWithin(names.back(), printable(parsed.get_ref<const std::string&>())));
    document.lines.insert_or_assign(names.back(), line);
    return true;
  };
  const char* const end = bytes.data() + bytes.size();
  try {
    document.value = json::parse(LineCounter(bytes.data(), &line), LineCounter(end, &line), follow);
    return document;
  } catch (const json::parse_error& error) {
    throw Error(ErrorKind::input,
                fmt::format("{}:{}: no valid JSON ({}); correct it there", printable(path.string()),
                            lineOf(bytes, error.byte), reasonIn(error.what())));
  } catch (const json::exception&) {
    fail(path, line, "a number is too large; use a smaller one");
  }
}

JsonFields::JsonFields(const JsonDocument& document, std::string name, const json& value,
                       std::initializer_list<const char*> known)
    : document_(document), name_(std::move(name)), object_(value) {
  if (!value.is_object()) {
    fail(document, name_,
         fmt::format("{} must be an object, not {}", name_.empty() ? "the file" : name_,
                     described(value)));
  }
  const std::vector<std::string> names(known.begin(), known.end());
  for (const auto& [key, ignored] : value.items()) {
    if (std::find(names.begin(), names.end(), key) != names.end()) continue;
    const std::string close = nearest(key, names);
    const std::string where = name_.empty() ? "" : fmt::format(" in {}", name_);
    fail(document, nameWithin(name_, printable(key)),
         fmt::format("unknown key \"{}\"{}; {}", printable(key), where,
                     close.empty() ? fmt::format("known are {}", fmt::join(names, ", "))
                                   : fmt::format("did you mean \"{}\"?", close)));
  }
}

const json* JsonFields::find(const char* key) const {
  const auto found = object_.find(key);
  return found == object_.end() ? nullptr : &*found;
}

std::string JsonFields::nameOf(const char* key) const {
  return nameWithin(name_, key);
}

void JsonFields::reject(const char* key, const std::string& what) const {
  fail(document_, nameOf(key),
       fmt::format("{} must be {}, not {}", nameOf(key), what, described(*find(key))));
}

std::optional<float> JsonFields::number(const char* key, const Range& range) const {
  const json* value = find(key);
  if (value == nullptr) return {};
  if (!inRange(*value, range)) reject(key, range.words);
  return value->get<float>();
}

std::optional<int> JsonFields::integer(const char* key, const Range& range) const {
  const json* value = find(key);
  if (value == nullptr) return {};
  if (!isInteger(*value, range)) reject(key, range.words);
  return value->get<int>();
}

std::optional<bool> JsonFields::boolean(const char* key) const {
  const json* value = find(key);
  if (value == nullptr) return {};
  if (!value->is_boolean()) reject(key, "true or false");
  return value->get<bool>();
}

std::optional<std::string> JsonFields::text(const char* key) const {
  const json* value = find(key);
  if (value == nullptr) return {};
  if (!value->is_string() || value->get_ref<const std::string&>().empty()) reject(key, "a text");
  return value->get<std::string>();
}

std::optional<Vec3> JsonFields::vector(const char* key, const Range& each) const {
  const std::optional<glm::dvec3> value = point(key, each);
  return value ? std::optional<Vec3>(*value) : std::nullopt;
}

std::optional<glm::dvec3> JsonFields::point(const char* key, const Range& each) const {
  const json* value = find(key);
  if (value == nullptr) return {};
  const std::string what = fmt::format("an array of three, each {}", each.words);
  if (!value->is_array() || value->size() != 3) reject(key, what);
  glm::dvec3 out{0};
  for (int i = 0; i < 3; ++i) {
    const json& element = (*value)[static_cast<std::size_t>(i)];
    if (!inRange(element, each)) {
      fail(
          document_, nameOf(key),
          fmt::format("{}[{}] must be {}, not {}", nameOf(key), i, each.words, described(element)));
    }
    out[i] = element.get<double>();
  }
  return out;
}

std::optional<std::array<int, 2>> JsonFields::integers(const char* key, const Range& each) const {
  const json* value = find(key);
  if (value == nullptr) return {};
  const std::string what = fmt::format("an array of two, each {}", each.words);
  if (!value->is_array() || value->size() != 2) reject(key, what);
  const json& first = (*value)[0];
  const json& second = (*value)[1];
  if (!isInteger(first, each) || !isInteger(second, each)) reject(key, what);
  return std::array<int, 2>{first.get<int>(), second.get<int>()};
}

const json* JsonFields::object(const char* key) const {
  const json* value = find(key);
  if (value != nullptr && !value->is_object()) reject(key, "an object");
  return value;
}

const json* JsonFields::array(const char* key) const {
  const json* value = find(key);
  if (value != nullptr && !value->is_array()) reject(key, "an array");
  return value;
}

}  // namespace glimt
