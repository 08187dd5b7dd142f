// Values that can be gone back to.
#pragma once

#include <cstddef>
#include <vector>

namespace glimt {

// Undo and redo over values of a type with ==. A drag of a slider is one step: what changes while
// it lasts is kept when it ends.
template <typename Value>
class History {
 public:
  explicit History(const Value& first) : steps_{first} {}

  // Where undo and redo have led to.
  const Value& now() const { return steps_[at_]; }

  // The value after a step. What was undone before is forgotten; a value like the last is no step.
  void keep(const Value& value) {
    if (value == now()) return;
    steps_.resize(at_ + 1);
    steps_.push_back(value);
    if (steps_.size() > kMost) steps_.erase(steps_.begin());
    at_ = steps_.size() - 1;
  }

  bool canUndo() const { return at_ > 0; }
  bool canRedo() const { return at_ + 1 < steps_.size(); }

  // Without a step to go there they do nothing.
  const Value& undo() {
    if (canUndo()) --at_;
    return now();
  }
  const Value& redo() {
    if (canRedo()) ++at_;
    return now();
  }

 private:
  static constexpr std::size_t kMost = 500;

  std::vector<Value> steps_;
  std::size_t at_ = 0;
};

}  // namespace glimt
