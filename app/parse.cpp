#include "app/parse.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "renderer/core/error.h"

namespace glimt {
namespace {

constexpr std::int64_t kLargestSide = 16384;

template <typename Number>
std::optional<Number> numberIn(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::optional<double> finiteNumberIn(std::string_view text) {
  const auto value = numberIn<double>(text);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return value;
}

[[noreturn]] void reject(const std::string& option, const std::string& text,
                         const std::string& wanted) {
  throw Error(ErrorKind::usage, fmt::format("{} takes {}, not '{}'", option, wanted, text));
}

}  // namespace

std::int64_t parseInteger(const std::string& option, const std::string& text, std::int64_t least,
                          std::int64_t most) {
  const auto value = numberIn<std::int64_t>(text);
  if (!value || *value < least || *value > most) {
    reject(option, text, fmt::format("a whole number from {} to {}", least, most));
  }
  return *value;
}

double parseNumber(const std::string& option, const std::string& text) {
  const auto value = finiteNumberIn(text);
  if (!value) reject(option, text, "a number");
  return *value;
}

double parseNumberBetween(const std::string& option, const std::string& text, double low,
                          double high) {
  const auto value = finiteNumberIn(text);
  // The value ends up in a float, where 179.99999999 is 180 and 1e-300 is 0.
  const auto narrow = static_cast<float>(value.value_or(low));
  if (!(narrow > low && narrow < high)) {
    reject(option, text, fmt::format("a number above {} and below {}", low, high));
  }
  return *value;
}

double parsePercent(const std::string& option, const std::string& text) {
  std::string_view number = text;
  if (number.ends_with('%')) number.remove_suffix(1);
  const auto value = finiteNumberIn(number);
  if (!value || *value < 0.001 || *value > 100) reject(option, text, "percent from 0.001 to 100");
  return *value;
}

std::array<int, 2> parseSize(const std::string& option, const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross != std::string::npos) {
    const auto width = numberIn<std::int64_t>(std::string_view(text).substr(0, cross));
    const auto height = numberIn<std::int64_t>(std::string_view(text).substr(cross + 1));
    const auto fits = [](auto side) { return side && *side >= 1 && *side <= kLargestSide; };
    if (fits(width) && fits(height)) {
      return {static_cast<int>(*width), static_cast<int>(*height)};
    }
  }
  reject(option, text, fmt::format("WIDTHxHEIGHT, each from 1 to {}", kLargestSide));
}

std::array<int, 2> parsePart(const std::string& option, const std::string& text) {
  constexpr std::int64_t kMostParts = 1'000'000;
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto part = numberIn<std::int64_t>(std::string_view(text).substr(0, slash));
    const auto parts = numberIn<std::int64_t>(std::string_view(text).substr(slash + 1));
    if (part && parts && *part >= 1 && *part <= *parts && *parts <= kMostParts)
      return {static_cast<int>(*part), static_cast<int>(*parts)};
  }
  reject(option, text, "I/N, a part and how many there are, like 3/8");
}

std::array<int, 2> parseSamples(const std::string& option, const std::string& text) {
  constexpr std::int64_t kMost = std::numeric_limits<int>::max();
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos) {
    const auto first = numberIn<std::int64_t>(std::string_view(text).substr(0, colon));
    const auto count = numberIn<std::int64_t>(std::string_view(text).substr(colon + 1));
    if (first && count && *first >= 0 && *first <= kMost && *count >= 1 && *count <= kMost - *first)
      return {static_cast<int>(*first), static_cast<int>(*count)};
  }
  reject(option, text, "FIRST:COUNT, like 0:64 or 64:64");
}

std::vector<std::string> parseNames(const std::string& option, const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end())
      reject(option, text, "different names with commas between them");
    names.push_back(name);
    begin = end + 1;
  }
  return names;
}

std::vector<std::string> parseChoices(const std::string& option, const std::string& text,
                                      const std::vector<std::string>& choices) {
  if (text == "all") return choices;
  std::vector<std::string> names = parseNames(option, text);
  for (const std::string& name : names)
    if (std::find(choices.begin(), choices.end(), name) == choices.end())
      reject(option, text, fmt::format("all, or some of {}", fmt::join(choices, ",")));
  return names;
}

glm::dvec3 parseVector(const std::string& option, const std::string& text) {
  glm::dvec3 vector{0};
  std::string_view rest = text;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t end = axis < 2 ? rest.find(',') : rest.size();
    if (end == std::string_view::npos) reject(option, text, "X,Y,Z");
    const auto value = finiteNumberIn(rest.substr(0, end));
    if (!value || std::abs(*value) > std::numeric_limits<float>::max()) {
      reject(option, text, "X,Y,Z");
    }
    vector[axis] = *value;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return vector;
}

std::string parseChoice(const std::string& option, const std::string& text,
                        const std::vector<std::string>& choices) {
  if (std::find(choices.begin(), choices.end(), text) == choices.end()) {
    reject(option, text, fmt::format("one of {}", fmt::join(choices, ", ")));
  }
  return text;
}

}  // namespace glimt
