// The worst error of a stream and the one that 99.9% stay below, in bounded memory.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace glimt::test {

// Errors are counted in buckets of which 32 make an octave, so that a percentile is at most 1/32
// too large, and never too small. What is not a number counts as infinite.
class ErrorStatistics {
 public:
  void add(double error) {
    if (!(error >= 0)) error = std::numeric_limits<double>::infinity();
    worst_ = std::max(worst_, error);
    ++buckets_[bucketOf(error)];
    ++count_;
  }

  std::uint64_t count() const { return count_; }
  double worst() const { return worst_; }

  // The least error that a `share` of all do not exceed.
  double percentile(double share) const {
    const double wanted = share * static_cast<double>(count_);
    double seen = 0;
    for (std::size_t i = 0; i < kBuckets; ++i) {
      seen += static_cast<double>(buckets_[i]);
      if (seen >= wanted) return std::min(topOf(i), worst_);
    }
    return worst_;
  }

 private:
  static constexpr int kPerOctave = 32;
  static constexpr int kLeastExponent = -100;  // smaller errors than 2^-100 count as zero
  static constexpr int kMostExponent = 100;
  static constexpr std::size_t kBuckets = (kMostExponent - kLeastExponent) * kPerOctave + 2;

  static std::size_t bucketOf(double error) {
    if (error < std::ldexp(1.0, kLeastExponent)) return 0;
    if (error >= std::ldexp(1.0, kMostExponent)) return kBuckets - 1;
    int exponent = 0;
    const double fraction = 2 * std::frexp(error, &exponent) - 1;  // in [0, 1)
    return static_cast<std::size_t>((exponent - 1 - kLeastExponent) * kPerOctave +
                                    static_cast<int>(fraction * kPerOctave) + 1);
  }

  static double topOf(std::size_t bucket) {
    if (bucket == 0) return 0;
    const int index = static_cast<int>(bucket) - 1;
    return std::ldexp(1 + (index % kPerOctave + 1) / double(kPerOctave),
                      index / kPerOctave + kLeastExponent);
  }

  std::array<std::uint64_t, kBuckets> buckets_{};
  std::uint64_t count_ = 0;
  double worst_ = 0;
};

}  // namespace glimt::test
