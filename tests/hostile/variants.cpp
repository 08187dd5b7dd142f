#include "tests/hostile/variants.h"

#include <algorithm>
#include <array>

namespace glimt {
namespace {

// std::uniform_int_distribution draws differently in every library.
std::size_t below(std::size_t count, Randomness& randomness) {
  return randomness() % std::max<std::size_t>(count, 1);
}

struct Stretch {
  std::size_t first;
  std::size_t length;
};

Stretch stretchOf(std::string_view bytes, Randomness& randomness) {
  const std::size_t first = below(bytes.size(), randomness);
  return {first, 1 + below(std::min<std::size_t>(bytes.size() - first, 64), randomness)};
}

void flipBit(std::string& bytes, Randomness& randomness) {
  char& byte = bytes[below(bytes.size(), randomness)];
  byte = static_cast<char>(byte ^ (1 << below(8, randomness)));
}

void overwrite(std::string& bytes, Randomness& randomness) {
  constexpr std::array kBytes = {'\0', '\x7f', '\x80', '\xff', '\n', ' ', '-', '9'};
  const auto [first, length] = stretchOf(bytes, randomness);
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(first), std::min<std::size_t>(length, 4),
              kBytes[below(kBytes.size(), randomness)]);
}

// A number in a text, or whatever stands there.
void makeExtreme(std::string& bytes, Randomness& randomness) {
  constexpr std::array kNumbers = {"nan",         "-inf", "1e999",      "-1e-999",
                                   "0",           "-1",   "2147483648", "-0",
                                   "-2147483648", "1e38", "65536",      "99999999999999999999"};
  const std::size_t start = below(bytes.size(), randomness);
  const std::size_t first = bytes.find_first_of("0123456789", start);
  if (first == std::string::npos) return;
  const std::size_t last = std::min(bytes.find_first_not_of("0123456789.", first), bytes.size());
  bytes.replace(first, last - first, kNumbers[below(kNumbers.size(), randomness)]);
}

void damageOnce(std::string& bytes, Randomness& randomness) {
  const auto [first, length] = stretchOf(bytes, randomness);
  const std::string stretch = bytes.substr(first, length);
  switch (below(8, randomness)) {
    case 0:
      bytes.resize(below(bytes.size(), randomness));
      break;
    case 1:
      bytes.erase(first, length);
      break;
    case 2:
      bytes.insert(first, stretch);
      break;
    case 3:
      bytes.insert(below(bytes.size(), randomness), stretch);
      break;
    case 4:
      overwrite(bytes, randomness);
      break;
    case 5:
      makeExtreme(bytes, randomness);
      break;
    default:
      flipBit(bytes, randomness);
  }
}

}  // namespace

std::string damaged(std::string_view bytes, Randomness& randomness) {
  std::string out(bytes);
  const std::size_t times = 1 + below(4, randomness);
  for (std::size_t i = 0; i < times && !out.empty(); ++i) damageOnce(out, randomness);
  return out;
}

}  // namespace glimt
