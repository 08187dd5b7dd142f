#include "app/json_output.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "app/output_files.h"
#include "renderer/core/error.h"
#include "renderer/core/file.h"

namespace glimt {

Json jsonOf(float value) {
  if (!std::isfinite(value)) return nullptr;
  return std::stod(fmt::format("{}", value));
}

Json jsonOf(const Vec3& vector) {
  return Json::array({jsonOf(vector.x), jsonOf(vector.y), jsonOf(vector.z)});
}

void writeOut(const std::string& text) {
  const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
  if (written != text.size() || std::fflush(stdout) != 0) {
    throw Error(ErrorKind::failed, "cannot write to standard output");
  }
}

void checkJsonFile(const std::string& file) {
  if (!file.empty() && file != "-") checkWritable(file);
}

void writeJson(const std::string& file, const Json& json) {
  if (file.empty()) return;
  // File names need not be UTF-8, JSON has to be.
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  if (file == "-") {
    writeOut(text);
  } else {
    writeFile(file, text);
  }
}

}  // namespace glimt
