#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "app/batch/batch_estimate.h"
#include "app/batch/batch_renderer.h"
#include "app/batch/contact_sheet.h"
#include "app/batch/manifest.h"
#include "app/batch/render_batch.h"
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/json_output.h"
#include "app/message.h"
#include "app/output_files.h"
#include "app/picture_files.h"
#include "app/picture_inputs.h"
#include "app/progress.h"
#include "app/stopwatch.h"
#include "renderer/core/display_transform.h"
#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/image_codecs.h"
#include "renderer/core/image_file.h"
#include "renderer/core/sha256.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestPicture = std::uintmax_t{4} << 30;
constexpr int kThumbnailSide = 256;
constexpr const char* kContactSheet = "contact-sheet.html";

template <typename Value>
Json jsonOrNull(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

class BatchCommand {
 public:
  BatchCommand(BatchJob job, const BatchOptions& options)
      : options_(options), job_(std::move(job)), renderer_(job_), progress_(!options.quiet) {
    if (!options.folder.empty()) job_.folder = options.folder;
  }

  void run();

 private:
  void plan();
  void make(const BatchPicture& picture);
  std::string inputsOf(const BatchPicture& picture);
  bool isUpToDate(const BatchPicture& picture, const std::string& inputs) const;
  Sampling render(const BatchPicture& picture);
  void write(const BatchPicture& picture, const Sampling& sampling, const std::string& inputs);
  void fail(const BatchPicture& picture, const std::string& what);
  void finish();
  void writeContactSheet();
  std::string thumbnail(const BatchPicture& picture);
  std::string title(const BatchPicture& picture) const;
  void warn(const Scene& scene);
  void endIfInterrupted() const;

  std::string fileOf(const BatchPicture& picture, const std::string& format) const {
    return picture.stem + "." + format;
  }
  fs::path manifestFile() const {
    return job_.folder / manifestName(options_.part, options_.parts);
  }

  const BatchOptions& options_;
  BatchJob job_;
  BatchRenderer renderer_;
  Progress progress_;
  std::optional<Interrupt> interrupt_;
  std::vector<BatchPicture> pictures_;  // of this process
  std::vector<std::string> all_files_;  // of the whole job
  Manifest manifest_;                   // of this process, or of the whole folder
  BatchEstimate estimate_;
  std::set<std::string> warnings_;
  std::size_t number_ = 0;  // of the picture under way, from 1
  int made_ = 0;
  int failed_ = 0;
};

void BatchCommand::run() {
  makeFolder(job_.folder);
  checkWritable(manifestFile());
  plan();
  interrupt_.emplace();
  for (const BatchPicture& picture : pictures_) {
    endIfInterrupted();
    ++number_;
    make(picture);
  }
  progress_.clear();
  finish();
}

void BatchCommand::plan() {
  progress_.show(fmt::format("loading {}", job_.scene.string()));
  const std::vector<BatchPicture> all = planOf(job_, renderer_.sceneOf(""));
  for (const BatchPicture& picture : all)
    for (const std::string& format : job_.formats) all_files_.push_back(fileOf(picture, format));
  pictures_ = partOf(all, options_.part, options_.parts);
  for (const BatchPicture& picture : pictures_) estimate_.plan(picture.size);
  manifest_ = readManifests(job_.folder);
  std::vector<std::string> own = all_files_;
  if (options_.parts > 1) {
    own.clear();
    for (const BatchPicture& picture : pictures_)
      for (const std::string& format : job_.formats) own.push_back(fileOf(picture, format));
  }
  manifest_.keepOnly(own);
}

// What goes wrong with one picture does not keep the others from being made, but for what goes
// wrong with all of them.
void BatchCommand::make(const BatchPicture& picture) {
  try {
    const std::string inputs = inputsOf(picture);
    if (isUpToDate(picture, inputs)) {
      estimate_.skip(picture.size);
      return;
    }
    const Stopwatch clock;
    const Sampling sampling = render(picture);
    if (sampling.ended_by == EndedBy::interrupt) endIfInterrupted();
    if (!sampling.failure.empty()) throw Error(ErrorKind::failed, sampling.failure);
    write(picture, sampling, inputs);
    estimate_.done(picture.size, clock.seconds());
    ++made_;
  } catch (const Error& error) {
    endIfInterrupted();
    if (error.kind() == ErrorKind::no_gl) throw;
    estimate_.skip(picture.size);
    fail(picture, error.what());
  }
}

// All that the file's bytes depend on. The device is not part of it: another one's picture differs
// in its last bits.
std::string BatchCommand::inputsOf(const BatchPicture& picture) {
  const Scene& scene = renderer_.sceneOf(picture);
  warn(scene);
  const RenderSettings settings = renderer_.settingsOf(picture);
  Json json = glimt::inputsOf(scene, settings);
  json["traversal"] = settings.traversal;
  json["gles"] = job_.picture.gles;
  json["backend"] = job_.backend;
  json["spp"] = jsonOrNull(job_.limits.samples);
  json["time"] = jsonOrNull(job_.limits.seconds);
  json["noise"] = jsonOrNull(job_.limits.noise);
  json["even"] = job_.even;
  json["denoise"] = job_.denoise;
  json["exposure"] = exposureOf(job_.picture, scene);
  json["tone"] = toneOf(job_.picture, scene);
  return sha256Of(json.dump());
}

bool BatchCommand::isUpToDate(const BatchPicture& picture, const std::string& inputs) const {
  return std::all_of(job_.formats.begin(), job_.formats.end(), [&](const std::string& format) {
    const std::string file = fileOf(picture, format);
    const ManifestEntry* const entry = manifest_.find(file);
    std::error_code ignored;
    return entry != nullptr && entry->inputs == inputs &&
           fs::is_regular_file(job_.folder / file, ignored) &&
           sha256Of(readFile(job_.folder / file, kLargestPicture)) == entry->sha256;
  });
}

Sampling BatchCommand::render(const BatchPicture& picture) {
  const auto progress = [&](float fraction) {
    endIfInterrupted();
    showTree(progress_, fraction);
  };
  const auto show = [&](const Sampling& done) {
    if (!progress_.due()) return;
    const auto left =
        estimate_.secondsLeft(picture.size, done.seconds, secondsLeft(job_.limits, done));
    progress_.show(fmt::format("{} of {}{}, {}: {}", number_, pictures_.size(),
                               left ? fmt::format(", {} left", duration(*left)) : "", picture.stem,
                               describe(job_.limits, done)));
  };
  return renderer_.render(picture, *interrupt_, progress, show);
}

// The manifest speaks of a file once it is there.
void BatchCommand::write(const BatchPicture& picture, const Sampling& sampling,
                         const std::string& inputs) {
  const Scene& scene = renderer_.sceneOf(picture);
  for (const std::string& format : job_.formats) {
    const std::string file = fileOf(picture, format);
    writePicture(job_.folder / file, sampling.picture.radiance, exposureOf(job_.picture, scene),
                 toneOf(job_.picture, scene));
    std::optional<double> noise;
    if (sampling.noise) noise = sampling.noise->upper;
    manifest_.add(ManifestEntry{file, picture.variant, picture.camera, picture.angle, picture.size,
                                sampling.samples, noise, sampling.seconds,
                                sha256Of(readFile(job_.folder / file, kLargestPicture)), inputs,
                                sampling.picture.radiance.denoised});
  }
  writeManifest(manifestFile(), manifest_);
}

void BatchCommand::fail(const BatchPicture& picture, const std::string& what) {
  ++failed_;
  progress_.clear();
  say(fmt::format("{}: {}", picture.stem, what));
  for (const std::string& format : job_.formats)
    manifest_.add(ManifestFailure{fileOf(picture, format), what});
  renderer_.forget();
  writeManifest(manifestFile(), manifest_);
}

void BatchCommand::finish() {
  const bool whole = options_.parts == 1;
  writeManifest(manifestFile(), manifest_);
  if (whole) {
    removePartManifests(job_.folder);
    writeContactSheet();
  }
  if (failed_ > 0)
    throw Error(ErrorKind::failed,
                fmt::format("{} of {} failed; the same command tries again",
                            counted(static_cast<std::uintmax_t>(failed_), "picture"),
                            grouped(pictures_.size())));
  if (options_.quiet) return;
  sayPlain(fmt::format("{}: {} made, {} up to date", (job_.folder / "").string(),
                       counted(static_cast<std::uintmax_t>(made_), "picture"),
                       grouped(pictures_.size() - static_cast<std::size_t>(made_))));
}

void BatchCommand::writeContactSheet() {
  std::vector<ContactSheetPicture> sheet;
  for (const BatchPicture& picture : pictures_) {
    endIfInterrupted();
    if (progress_.due())
      progress_.show(fmt::format("contact sheet, {} of {}", sheet.size(), pictures_.size()));
    const std::string file = fileOf(picture, job_.formats.front());
    const ManifestEntry* const entry = manifest_.find(file);
    std::string note = "failed";
    if (entry != nullptr)
      note = counted(static_cast<std::uintmax_t>(entry->samples), "sample") +
             (entry->noise ? ", noise " + percent(*entry->noise) : "") +
             (entry->denoised ? ", denoised" : "");
    std::string view = fmt::format("{}x{}", picture.size[0], picture.size[1]);
    if (picture.angle) view = fmt::format("{:g}°, {}", *picture.angle, view);
    if (!picture.camera.empty()) view = picture.camera + ", " + view;
    sheet.push_back({picture.variant, view, file, note, entry ? thumbnail(picture) : ""});
  }
  progress_.clear();
  writeFile(job_.folder / kContactSheet, contactSheet(job_.file.stem().stem().string(), sheet));
}

// As a display shows it.
std::string BatchCommand::thumbnail(const BatchPicture& picture) {
  const fs::path file = job_.folder / fileOf(picture, job_.formats.front());
  if (imageFormatOf(file) == ImageFormat::png)
    return encodePng(
        displayImage(reduced(shownImage(readFile(file, kLargestPicture)), kThumbnailSide), 0));
  const Image small = reduced(readImage(file), kThumbnailSide);
  const Scene& scene = renderer_.sceneOf(picture.variant);
  return encodePng(
      displayImage(small, exposureOf(job_.picture, scene), toneOf(job_.picture, scene)));
}

void BatchCommand::warn(const Scene& scene) {
  for (const std::string& warning : scene.warnings) {
    if (!warnings_.insert(warning).second || options_.quiet) continue;
    progress_.clear();
    say("warning: " + warning);
  }
}

void BatchCommand::endIfInterrupted() const {
  if (!interrupt_->requested()) return;
  throw Error(ErrorKind::failed,
              fmt::format("interrupted, {} made; the same command goes on",
                          counted(static_cast<std::uintmax_t>(made_), "picture")));
}

}  // namespace

int runBatch(const BatchOptions& options) {
  BatchCommand(readBatchJob(options.job), options).run();
  return 0;
}

int runBatch(const RenderOptions& options) {
  BatchOptions batch;
  batch.quiet = options.quiet;
  BatchCommand(batchJobOf(options), batch).run();
  return 0;
}

}  // namespace glimt
