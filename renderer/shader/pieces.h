// The files of shaders/ that fragment shaders are put together from, and when: a new effect is a
// row of this table.
#pragma once

#include <span>
#include <string_view>

#include "renderer/core/effects.h"
#include "renderer/shader/pass.h"

namespace glimt {

// Which passes a file is part of: a bit for each.
constexpr unsigned bit(Pass pass) {
  return 1u << static_cast<unsigned>(pass);
}
inline constexpr unsigned kCamera = bit(Pass::camera);
inline constexpr unsigned kTrace = bit(Pass::trace);
inline constexpr unsigned kDelta = bit(Pass::delta);
inline constexpr unsigned kScatter = kTrace | kDelta;            // from a hit record to the next
inline constexpr unsigned kWholePath = bit(Pass::display) << 1;  // no pass; see composePathProbe

// When a file is part of a shader: where the scene calls for one of some effects, and for none of
// some others.
struct Condition {
  unsigned any_of = 0;  // a bit for each effect; 0: always
  unsigned none_of = 0;

  constexpr Condition butNot(unsigned effects) const { return {any_of, effects}; }
};

bool isMet(const Condition& condition, const EffectSet& effects);

struct Piece {
  std::string_view file;
  unsigned passes;
  Condition condition;
};

// Stands for the files of the traversal that was asked for.
inline constexpr std::string_view kTraversal = "traverse_*.glsl";

// Stand for the files of the record that was asked for.
inline constexpr std::string_view kRecordInput = "*_record_input.glsl";
inline constexpr std::string_view kRecordOutput = "*_record_output.glsl";

// Stands for what dims bright samples, where that was asked for.
inline constexpr std::string_view kClamp = "sample_clamp.glsl";

// Stands for what takes other than the radiance from a sample, where that was asked for.
inline constexpr std::string_view kAccumulated = "*_accumulated.glsl";

// Stands for the file of the tone that was asked for.
inline constexpr std::string_view kTone = "tone_*.glsl";

// In the order in which they are put together: a file comes after those that it calls.
std::span<const Piece> shaderPieces();

}  // namespace glimt
