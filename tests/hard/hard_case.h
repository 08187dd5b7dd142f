// A hard case: something that path tracers get wrong, a figure for how wrong, and a bound for it.
// Runs on the driver that the environment names, and leaves a row for docs/hard-cases.md.
#pragma once

#include <string>

#include "renderer/renderer.h"

namespace glimt::test {

// The driver under test, as GLIMT_HARD_DRIVER names it: "llvmpipe" (also without that variable),
// "osmesa", "softpipe" or "zink". The caller's environment makes Mesa take it; see CMakeLists.txt.
// Any other name is that of a driver which EGL finds by itself.
std::string hardDriver();

// A context of that driver. Errors: as createOffscreenContext.
ContextHandle hardContext();

// Whether pictures have to be small and samples few: "softpipe" and "zink" take their time.
bool slowDriver();

// Checks that `measured` is at most `bound`, and appends a line "group, case, what, bound,
// measured, driver" with tabs between to the file that GLIMT_HARD_REPORT names, if it names one.
// `what` says in a few words what is measured, with its unit: "mean difference, relative".
void checkAtMost(const std::string& group, const std::string& name, const std::string& what,
                 double measured, double bound);

}  // namespace glimt::test
