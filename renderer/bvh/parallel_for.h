#pragma once

#include <cstddef>
#include <functional>

namespace glimt {

// Calls body(0) to body(count - 1), each once and in no order, on so many threads: the calling one
// and others, or fewer where the system has no more to give. One thread means no other is created.
// The first exception that a call throws ends the work and is thrown here.
void parallelFor(unsigned threads, std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace glimt
