#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/json_output.h"
#include "renderer/core/error.h"
#include "renderer/doctor.h"

namespace glimt {
namespace {

Json jsonOf(const std::vector<Finding>& findings, const ContextInfo& context) {
  Json list = Json::array();
  for (const Finding& finding : findings)
    list.push_back({{"name", finding.name},
                    {"result", finding.result},
                    {"verdict", nameOf(finding.verdict)},
                    {"consequence", finding.consequence}});
  return {{"backend", context.backend},    {"gl_renderer", context.renderer},
          {"gl_version", context.version}, {"gles", context.gles},
          {"usable", isUsable(findings)},  {"findings", list}};
}

std::string textOf(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings)
    text += fmt::format("{:<8} {:<23} {}\n{:<8} {}\n", nameOf(finding.verdict), finding.name,
                        finding.result, "", finding.consequence);
  if (!isUsable(findings)) return text + "pictures would be wrong here\n";
  const bool limited = std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.verdict == Verdict::warning;
  });
  return text + fmt::format("pictures come out right here{}\n",
                            limited ? ", within the limits that the warnings tell" : "");
}

}  // namespace

int runDoctor(const DoctorOptions& options) {
  checkJsonFile(options.json);
  ContextHandle context = createOffscreenContext(options.backend, options.gles);
  const std::vector<Finding> findings = examine(context);
  // The table would spoil a report on the same output.
  if (options.json != "-") writeOut(textOf(findings));
  writeJson(options.json, jsonOf(findings, context.info()));
  return isUsable(findings) ? 0 : static_cast<int>(ErrorKind::no_gl);
}

}  // namespace glimt
