#include "tests/hostile/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace glimt {
namespace {

namespace fs = std::filesystem;

constexpr RunLimits kLimits;
constexpr std::int64_t kMostMemory = std::int64_t{2} << 30;

#ifdef GLIMT_SANITIZE
// Leaks are looked for where no driver is loaded: those of Mesa are not ours.
const std::vector<std::string> kLoading = {"ASAN_OPTIONS=detect_leaks=1:quarantine_size_mb=16"};
const std::vector<std::string> kRendering = {"ASAN_OPTIONS=detect_leaks=0:quarantine_size_mb=16"};
#else
const std::vector<std::string> kLoading = {};
const std::vector<std::string> kRendering = {};
#endif

std::string faultOfRun(const RunResult& run) {
  const std::string last = run.lines.empty() ? "" : ": " + run.lines.back();
  if (run.out_of_time)
    return fmt::format("took more than {} s, or did nothing for long", kLimits.seconds);
  if (run.signal != 0) return fmt::format("ended by signal {}{}", run.signal, last);
  if (run.peak_bytes > kMostMemory) {
    return fmt::format("took {} MiB of memory", run.peak_bytes >> 20);
  }
  return {};
}

bool isPicture(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  char magic[4] = {};
  file.read(magic, 4);
  return file && std::string_view(magic, 4) == "\x89PNG";
}

// Warnings, and behind them the line that sums up.
std::string faultOfPictureLines(const std::vector<std::string>& lines, bool& warned) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool warning = lines[i].starts_with("glimt: warning: ");
    warned = warned || warning;
    if (!warning && i + 1 < lines.size()) return "neither a warning nor the last line: " + lines[i];
  }
  return {};
}

Verdict render(const fs::path& scene, const fs::path& folder, Verdict verdict) {
  const fs::path picture = folder / "picture.png";
  std::error_code ignored;
  fs::remove(picture, ignored);
  const RunResult run = runLimited({GLIMT_PROGRAM, "render", scene.string(), "-o", picture.string(),
                                    "--size", "4x4", "--spp", "1", "--bounces", "1"},
                                   kLimits, kRendering);
  verdict.seconds = std::max(verdict.seconds, run.seconds);
  verdict.peak_bytes = std::max(verdict.peak_bytes, run.peak_bytes);
  verdict.fault = faultOfRun(run);
  bool warned = false;
  if (verdict.fault.empty() && run.status != 0) {
    // What only the device can refuse: more triangles than its textures take.
    verdict.fault = faultOfRefusal(run, 3);
    if (verdict.fault.empty()) verdict.ending = Ending::refused;
    return verdict;
  }
  if (verdict.fault.empty()) verdict.fault = faultOfPictureLines(run.lines, warned);
  if (verdict.fault.empty() && !isPicture(picture)) verdict.fault = "no picture was written";
  if (verdict.fault.empty()) {
    verdict.ending = warned ? Ending::picture_with_warnings : Ending::picture;
  }
  return verdict;
}

std::string lowerExtension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

constexpr const char* kTriangle = "mtllib x.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

fs::path written(const fs::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

// Names within JSON: these hold no control characters.
std::string quoted(const std::string& name) {
  std::string out = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

}  // namespace

std::string faultOfRefusal(const RunResult& run, int status) {
  if (std::string fault = faultOfRun(run); !fault.empty()) return fault;
  const std::string last = run.lines.empty() ? "" : ": " + run.lines.back();
  if (run.status != status) return fmt::format("exit status {}{}", run.status, last);
  const auto errors = std::count_if(run.lines.begin(), run.lines.end(), [](const auto& line) {
    return !line.starts_with("glimt: warning: ");
  });
  if (errors != 1) return fmt::format("{} lines of errors{}", errors, last);
  const std::string& line = run.lines.back();
  const std::size_t what = line.find(": ", 7);
  if (!line.starts_with("glimt: ") || line.starts_with("glimt: unexpected") ||
      what == std::string::npos ||
      (line.find("; ", what) == std::string::npos &&
       line.find(" must be ", what) == std::string::npos)) {
    return "does not say where, what, and what to do" + last;
  }
  return {};
}

Verdict judge(const fs::path& scene, const fs::path& folder) {
  const RunResult run = runLimited({GLIMT_PROGRAM, "info", scene.string()}, kLimits, kLoading);
  Verdict verdict;
  verdict.seconds = run.seconds;
  verdict.peak_bytes = run.peak_bytes;
  verdict.fault = faultOfRun(run);
  if (!verdict.fault.empty()) return verdict;
  if (run.status == 0) return render(scene, folder, verdict);
  verdict.fault = faultOfRefusal(run, 3);
  if (verdict.fault.empty()) verdict.ending = Ending::refused;
  return verdict;
}

Verdict judgeFile(const fs::path& file, const fs::path& folder) {
  const std::string extension = lowerExtension(file);
  const std::vector<std::string> pictures = {".bmp", ".exr", ".hdr", ".jpeg",
                                             ".jpg", ".pfm", ".png", ".tga"};
  if (std::find(pictures.begin(), pictures.end(), extension) != pictures.end()) {
    written(folder / "x.obj", kTriangle);
    return judge(written(folder / "x.scene.json",
                         fmt::format(R"({{"model": "x.obj", "environment": {{"image": {}}}}})",
                                     quoted(fs::absolute(file).string()))),
                 folder);
  }
  if (extension == ".mtl") {
    fs::copy_file(file, folder / "x.mtl", fs::copy_options::overwrite_existing);
    fs::permissions(folder / "x.mtl", fs::perms::owner_all);
    return judge(written(folder / "x.obj", kTriangle), folder);
  }
  return judge(file, folder);
}

void Tally::add(const std::string& name, const Verdict& verdict) {
  ++files_;
  ++counts_[static_cast<std::size_t>(verdict.ending)];
  slowest_ = std::max(slowest_, verdict.seconds);
  largest_ = std::max(largest_, verdict.peak_bytes);
  if (verdict.ending == Ending::wrong) faults_.push_back(name + ": " + verdict.fault);
}

void Tally::report() const {
  const std::string row =
      fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{:.1f}\t{}\n", group_, files_, counts_[0], counts_[1],
                  counts_[2], counts_[3], slowest_, largest_ >> 20);
  std::cout << fmt::format(
      "{}: {} files: {} pictures, {} with warnings, {} refused, {} otherwise; at most {:.1f} s and "
      "{} MiB\n",
      group_, files_, counts_[0], counts_[1], counts_[2], counts_[3], slowest_, largest_ >> 20);
  if (const char* report = std::getenv("GLIMT_HOSTILE_REPORT")) {
    std::ofstream(report, std::ios::app) << row;
  }
}

}  // namespace glimt
