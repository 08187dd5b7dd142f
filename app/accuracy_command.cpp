#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/accuracy/measurement.h"
#include "app/accuracy/report_data.h"
#include "app/accuracy/report_page.h"
#include "app/accuracy/variants.h"
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "app/output_files.h"
#include "app/progress.h"
#include "app/stopwatch.h"
#include "renderer/core/display_transform.h"
#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/flip.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"
#include "renderer/scene/load_scene.h"

namespace glimt {
namespace {

// Larger pictures are measured smaller: their error is the same, and more variants can be tried.
constexpr double kMostPixels = 256 * 256;

constexpr std::uintmax_t kMostPngBytes = 1 << 28;
constexpr int kWholeSamples = 3;

class AccuracyCommand {
 public:
  explicit AccuracyCommand(const AccuracyOptions& options)
      : options_(options), progress_(!options.quiet) {}

  void run();

 private:
  Scene load();
  AccuracyPlan planFor(const Scene& scene, const RenderSettings& settings) const;
  RenderSettings measuredSettings(const RenderSettings& settings) const;
  double timeFactor(const Scene& scene, const RenderSettings& settings,
                    const RenderSettings& measured) const;
  void report(const std::string& what, double share);
  void write(const ReportSubject& subject, const AccuracyResult& result, const Scene& scene);
  std::string png(const std::string& name, const DisplayImage& image) const;
  std::vector<ReportPicture> picturesOf(const AccuracyResult& result, float exposure,
                                        Tone tone) const;

  const AccuracyOptions& options_;
  Stopwatch clock_;
  std::optional<Interrupt> interrupt_;
  Progress progress_;
};

RenderSettings AccuracyCommand::measuredSettings(const RenderSettings& settings) const {
  RenderSettings measured = settings;
  if (options_.reference) {
    const Image reference = readImage(*options_.reference);
    if (options_.picture.size) return measured;
    measured.width = reference.width;
    measured.height = reference.height;
    return measured;
  }
  const double pixels = static_cast<double>(settings.width) * settings.height;
  if (pixels <= kMostPixels) return measured;
  const double scale = std::sqrt(kMostPixels / pixels);
  const auto side = [&](int whole) { return std::max(static_cast<int>(whole * scale + 0.5), 1); };
  measured.width = side(settings.width);
  measured.height = side(settings.height);
  return measured;
}

AccuracyPlan AccuracyCommand::planFor(const Scene& scene, const RenderSettings& settings) const {
  AccuracyPlan plan;
  plan.variants = accuracyVariants(scene, settings, options_.picture.gles);
  plan.backend = options_.backend;
  plan.folder = options_.folder;
  plan.reference = options_.reference;
  plan.seconds = options_.seconds;
  plan.key = {{"version", GLIMT_VERSION},
              {"scene", options_.scene.string()},
              {"reference", options_.reference ? options_.reference->string() : ""},
              {"options", options_.arguments},
              {"width", settings.width},
              {"height", settings.height},
              {"seconds", options_.seconds}};
  return plan;
}

// How many times as long a sample of the whole picture takes, measured one after the other.
double AccuracyCommand::timeFactor(const Scene& scene, const RenderSettings& settings,
                                   const RenderSettings& measured) const {
  if (settings.width == measured.width && settings.height == measured.height) return 1;
  ContextHandle context = createOffscreenContext(options_.backend, options_.picture.gles);
  Renderer renderer(context, scene, settings);
  const auto secondsOf = [&](const RenderSettings& size) {
    renderer.resize(size.width, size.height);
    renderer.renderSample();
    const Stopwatch clock;
    for (int i = 0; i < kWholeSamples; ++i) renderer.renderSample();
    return clock.seconds();
  };
  secondsOf(measured);  // a first time, for drivers that warm up
  const double whole = secondsOf(settings);
  return whole / secondsOf(measured);
}

void AccuracyCommand::report(const std::string& what, double share) {
  if (interrupt_->requested())
    throw Error(ErrorKind::failed,
                fmt::format("interrupted; what is done is kept in {}: the same command goes on",
                            printable(options_.folder.string())));
  if (!progress_.due()) return;
  const double spent = clock_.seconds();
  const std::string left =
      share > 0.02 ? fmt::format(", {} left", duration(spent / share * (1 - share))) : "";
  progress_.show(fmt::format("{:.0f}%: {}{}", 100 * share, what, left));
}

std::string AccuracyCommand::png(const std::string& name, const DisplayImage& image) const {
  const std::filesystem::path file = options_.folder / (name + ".png");
  writeDisplayImage(file, image);
  return readFile(file, kMostPngBytes);
}

// Some of the first samples of the picture as asked for, what the others have come to, and the
// reference.
std::vector<ReportPicture> AccuracyCommand::picturesOf(const AccuracyResult& result, float exposure,
                                                       Tone tone) const {
  const DisplayImage reference =
      displayImage(readImage(options_.folder / kReferencePicture), exposure, tone);
  std::vector<ReportPicture> pictures;
  const auto add = [&](const std::string& name, const std::string& file) {
    const DisplayImage image = displayImage(readImage(options_.folder / file), exposure, tone);
    const FlipDifference flip = flipOf(image, reference);
    const std::string stem = std::filesystem::path(file).stem().string();
    pictures.push_back({fmt::format("{}, FLIP {:.3f}", name, flip.mean), png(stem, image),
                        png(stem + "-difference", flipPicture(flip, image.width, image.height))});
  };
  for (const AccuracyCurve& curve : result.curves) {
    if (curve.knob == "traversal") continue;  // the same picture
    for (const AccuracyPoint& point : curve.points) {
      const bool last = &point == &curve.points.back();
      if (!last && (!curve.knob.empty() || (point.samples != 1 && point.samples != 16))) continue;
      add(fmt::format("{}, {}", curve.name(),
                      counted(static_cast<std::uintmax_t>(point.samples), "sample")),
          pictureFile(curve.name(), point.samples));
    }
  }
  pictures.push_back({"reference", png("reference", reference), ""});
  return pictures;
}

Scene AccuracyCommand::load() {
  progress_.show(fmt::format("loading {}", options_.scene.string()));
  Scene scene = loadScene(options_.scene, {options_.load.variant, options_.picture.environment,
                                           options_.picture.transparent_background});
  scene.camera = cameraOf(options_.picture.camera, scene);
  progress_.clear();
  if (!options_.quiet)
    for (const std::string& warning : scene.warnings) say("warning: " + warning);
  return scene;
}

void AccuracyCommand::write(const ReportSubject& subject, const AccuracyResult& result,
                            const Scene& scene) {
  progress_.show("writing the report");
  const std::vector<ReportPicture> pictures =
      picturesOf(result, exposureOf(options_.picture, scene), toneOf(options_.picture, scene));
  writeFile(options_.folder / "report.json", jsonReport(subject, result).dump(2) + "\n");
  writeFile(options_.folder / "report.csv", csvReport(subject, result));
  writeFile(options_.folder / "report.html", reportPage(subject, result, pictures));
  progress_.clear();
}

void AccuracyCommand::run() {
  makeFolder(options_.folder);
  const Scene scene = load();
  const RenderSettings settings = settingsOf(options_.picture, scene);
  const RenderSettings measured = measuredSettings(settings);
  interrupt_.emplace();
  const AccuracyResult result =
      measureAccuracy(planFor(scene, measured), scene,
                      [this](const std::string& what, double share) { report(what, share); });
  progress_.show("how long the whole picture takes");
  const ReportSubject subject{options_.scene.string(),
                              options_.arguments,
                              settings.width,
                              settings.height,
                              measured.width,
                              measured.height,
                              timeFactor(scene, settings, measured),
                              GLIMT_VERSION};
  write(subject, result, scene);
  if (!options_.quiet)
    sayPlain(fmt::format("{} in {}", (options_.folder / "report.html").string(),
                         duration(clock_.seconds())));
}

}  // namespace

int runAccuracy(const AccuracyOptions& options) {
  AccuracyCommand(options).run();
  return 0;
}

}  // namespace glimt
