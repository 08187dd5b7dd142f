// The packed hit record (shaders/hit_record.glsl) as the device writes and reads it.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/gl/device.h"

namespace glimt {

// What a record holds; see HitRecord in shaders/hit_record.glsl.
struct RecordValues {
  float triangle = 0;
  float back = 0;
  Vec2 uv{0};
  Vec3 direction{0};
  Vec3 throughput{0};
  float weight = 0;
  bool ended = false;  // nothing was stored, since the path is too weak to go on
};

// Packs records into texels. `random` has four numbers in [0, 1) for each.
std::vector<Vec4> encodeRecords(const gl::Device& device, const std::vector<RecordValues>& records,
                                const std::vector<Vec4>& random);
std::vector<RecordValues> decodeRecords(const gl::Device& device, const std::vector<Vec4>& texels);

struct RecordProbe {
  std::size_t records = 0;  // packed, written, read and unpacked
  std::size_t wrong = 0;    // of them, those with a value further off than its rounding allows
};
RecordProbe probeRecords(const gl::Device& device);

// How far the mean of many records of the same path is from what went in, in standard errors of
// that mean: the worst of throughput, weight and position.
double probeRounding(const gl::Device& device);

}  // namespace glimt
