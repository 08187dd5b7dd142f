// Shader text evaluated on the device is the library's; tests name it with what is theirs.
#pragma once

#include "renderer/probes/probe.h"

namespace glimt::test {

using glimt::Probe;
using glimt::probeMain;

}  // namespace glimt::test
