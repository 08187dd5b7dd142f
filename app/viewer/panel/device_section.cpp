#include <fmt/format.h>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"

namespace glimt {

void drawDeviceSection(const PanelData& data) {
  drawRow("renderer", printable(data.device.renderer));
  drawRow("version", printable(data.device.version));
  drawRow("context", data.device.backend);
  drawRow("traversal", data.status.statistics.traversal);
  drawRow("record", data.record);
  drawRow("shaders",
          fmt::format("{} to compile", duration(data.status.statistics.compile_seconds)));
  if (data.pace.frames_per_second > 0)
    drawRow("moving", fmt::format("{:.0f} frames a second", data.pace.frames_per_second));
  if (data.pace.latency > 0)
    drawRow("answers", fmt::format("after {:.0f} ms", 1000 * data.pace.latency));
}

}  // namespace glimt
