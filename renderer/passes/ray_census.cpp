#include "renderer/passes/ray_census.h"

#include <bit>
#include <cstdint>

namespace glimt {
namespace {

// Whether a packed hit record is of a path that has met a triangle; see shaders/hit_record.glsl,
// whose first channel holds the triangle in its mantissa.
bool isPackedHit(const Vec4& record) {
  constexpr std::uint32_t kMantissa = (1u << 23) - 1;
  constexpr std::uint32_t kUnknown = kMantissa - 1;
  return record.x != 0 && (std::bit_cast<std::uint32_t>(record.x) & kMantissa) < kUnknown;
}

// The same for the first texel of a wide one; see shaders/wide_record_input.glsl.
bool isWideHit(const Vec4& record) {
  constexpr float kUnknown = 8388606;
  return record.x > 0.5f && record.y < kUnknown;
}

}  // namespace

void RayCensus::forget() {
  complete_ = false;
  alive_.clear();
}

void RayCensus::count(const std::vector<Vec4>& records, const std::string& record, int bounce,
                      int last_bounce) {
  const auto isHit = record == "wide" ? isWideHit : isPackedHit;
  if (bounce == 0) {
    alive_.clear();
    lengths_.assign(records.size(), 0);
    rays_ = {static_cast<double>(records.size()), 0, 0};
  }
  double hits = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!isHit(records[i])) continue;
    ++hits;
    ++lengths_[i];
  }
  alive_.push_back(hits / static_cast<double>(records.size()));
  complete_ = bounce == last_bounce;
  if (!complete_) rays_.bounce += hits;
  rays_.shadow += hits;
}

bool RayCensus::endsEarly(int last_bounce) {
  if (complete_ || alive_.back() != 0) return false;
  alive_.resize(static_cast<std::size_t>(last_bounce) + 1);
  complete_ = true;
  return true;
}

}  // namespace glimt
