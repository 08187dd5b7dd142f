#include "renderer/core/wording.h"

#include <fmt/format.h>

#include <algorithm>

namespace glimt {
namespace {

constexpr std::size_t kLongestText = 400;
constexpr std::size_t kMostNames = 5;

// Levenshtein distance: how many letters to insert, drop or change.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string grouped(std::uintmax_t number) {
  std::string digits = fmt::format("{}", number);
  for (std::size_t from_right = 3; from_right < digits.size(); from_right += 4) {
    digits.insert(digits.size() - from_right, 1, ',');
  }
  return digits;
}

std::string counted(std::uintmax_t number, std::string_view noun) {
  return fmt::format("{} {}{}", grouped(number), noun, number == 1 ? "" : "s");
}

std::string duration(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 100 * 60) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string percent(double share) {
  const double value = 100 * share;
  if (value >= 9.95) return fmt::format("{:.0f}%", value);
  return fmt::format("{:.{}f}%", value, value >= 0.995 ? 1 : 2);
}

std::string printable(std::string_view text) {
  std::string out(text.substr(0, kLongestText));
  for (char& c : out) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = '?';
  }
  if (text.size() > kLongestText) out += "...";
  return out;
}

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  const std::size_t shown = names.size() <= kMostNames ? names.size() : kMostNames - 1;
  for (std::size_t i = 0; i < shown; ++i) {
    const char* separator = i == 0 ? "" : (i + 1 == names.size() ? " and " : ", ");
    out += fmt::format("{}'{}'", separator, printable(std::string_view(names[i]).substr(0, 60)));
  }
  if (shown < names.size()) out += fmt::format(" and {} more", grouped(names.size() - shown));
  return out;
}

std::string nearest(std::string_view name, const std::vector<std::string>& known) {
  if (name.size() > 60) return {};
  std::string best;
  std::size_t best_distance = 1 + name.size() / 3;
  for (const std::string& candidate : known) {
    const std::size_t distance = editDistance(name, candidate);
    if (distance < best_distance || (distance == best_distance && best.empty())) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace glimt
