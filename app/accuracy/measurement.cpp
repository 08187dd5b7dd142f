#include "app/accuracy/measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <utility>

#include "app/stopwatch.h"
#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/image_difference.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr double kReferenceShare = 0.35;  // of the time
constexpr double kSharesAsAsked = 5;      // of the rest
constexpr double kLimitSeconds = 0.7;
constexpr int kMostSamples = 1 << 20;

// A picture that is as wrong as the reference says nothing.
constexpr double kLeastOfReference = 1.5;

constexpr std::uintmax_t kMostBytes = 1 << 24;  // of a piece of JSON

std::string fileNameOf(std::string name) {
  for (char& c : name)
    if (c == ' ' || c == '/') c = '-';
  return name;
}

std::string curveFile(const std::string& variant) {
  return fileNameOf(variant) + ".json";
}

// Powers of two.
bool isPoint(int samples) {
  return std::has_single_bit(static_cast<unsigned>(samples));
}

// Of the last picture whose noise is known; else none.
ErrorBudget budgetOf(const AccuracyCurve& curve, const LimitError& limits) {
  const AccuracyPoint& last = curve.points.back();
  if (last.noise == 0) return {};
  return {last.samples, last.noise, limits.truncation,    limits.clamp,
          limits.both,  last.error, limits.enough_bounces};
}

double sharesOf(const AccuracyVariant& variant) {
  return variant.knob.empty() ? kSharesAsAsked : 1;
}

class Measurement {
 public:
  Measurement(const AccuracyPlan& plan, const Scene& scene, const AccuracyProgress& progress)
      : plan_(plan), scene_(scene), progress_(progress) {}

  AccuracyResult run();

 private:
  Json kept(const std::string& file) const;
  void keep(const std::string& file, Json json) const;
  void takeReference();
  void renderReference();
  void demandSize() const;
  void measure(const AccuracyVariant& variant);
  AccuracyCurve render(const AccuracyVariant& variant, double seconds);
  void addPoint(const AccuracyVariant& variant, double seconds, AccuracyCurve& curve);
  void makeRenderer(const AccuracyVariant& variant);
  const LimitError& limitsOf(const AccuracyVariant& variant, double noise);
  double secondsFor(const AccuracyVariant& variant) const;
  void show(const std::string& what);

  const AccuracyPlan& plan_;
  const Scene& scene_;
  const AccuracyProgress& progress_;
  AccuracyResult result_;
  Image reference_;
  std::optional<ContextHandle> context_;
  std::optional<Renderer> renderer_;
  std::optional<AccuracyVariant> current_;                 // that the renderer is of
  std::deque<std::pair<LightLimits, LimitError>> limits_;  // measured so far
  double steps_done_ = 0;
};

// Nothing where there is none, or it is of something else.
Json Measurement::kept(const std::string& file) const {
  if (!std::filesystem::exists(plan_.folder / file)) return nullptr;
  const Json json = Json::parse(readFile(plan_.folder / file, kMostBytes), nullptr, false);
  return json.is_object() && json.value("key", Json()) == plan_.key ? json : nullptr;
}

void Measurement::keep(const std::string& file, Json json) const {
  json["key"] = plan_.key;
  writeFile(plan_.folder / file, json.dump(1) + "\n");
}

void Measurement::show(const std::string& what) {
  progress_(what, steps_done_);
}

void Measurement::makeRenderer(const AccuracyVariant& variant) {
  if (current_ && shareRenderer(*current_, variant)) return;
  current_.reset();
  renderer_.reset();
  context_.reset();
  context_.emplace(createOffscreenContext(plan_.backend, variant.gles));
  renderer_.emplace(*context_, sceneOf(variant, scene_), variant.settings);
  current_ = variant;
}

// Without limits, and with other random numbers.
void Measurement::renderReference() {
  AccuracyVariant exact = plan_.variants.front();
  exact.settings.clamp.reset();
  exact.settings.sampler = Sampler::sobol;
  exact.settings.seed += 1000;
  show("reference");
  makeRenderer(exact);
  const LimitError limits = measureLimits(*renderer_, exact.settings, 0.001, kLimitSeconds);
  const int bounces = std::max(limits.all_bounces, exact.settings.bounces);
  renderer_->resize(exact.settings.width, exact.settings.height);
  renderer_->setLimits({bounces, {}});
  renderer_->setSampler(exact.settings.sampler, exact.settings.seed);
  const Stopwatch clock;
  const double seconds = kReferenceShare * plan_.seconds;
  // Whole powers of two of samples are the most exact for their time.
  while (clock.seconds() < seconds || renderer_->samples() < 16) {
    renderer_->renderSample();
    const int samples = renderer_->samples();
    progress_(fmt::format("reference, {} samples", samples),
              kReferenceShare * std::min(clock.seconds() / seconds, 1.0));
    if (isPoint(samples) && 2 * clock.seconds() > 1.3 * seconds && samples >= 16) break;
  }
  const std::optional<NoiseEstimate> noise = renderer_->noiseNow();
  reference_ = renderer_->radiance();
  writeImage(plan_.folder / kReferencePicture, reference_);
  result_.reference_samples = renderer_->samples();
  result_.reference_noise = noise ? noise->relative : 0;
  result_.reference_bounces = bounces;
  keep("reference.json", {{"samples", result_.reference_samples},
                          {"noise", result_.reference_noise},
                          {"bounces", bounces}});
}

void Measurement::takeReference() {
  if (plan_.reference) {
    reference_ = readImage(*plan_.reference);
    demandSize();
    writeImage(plan_.folder / kReferencePicture, reference_);
    return;
  }
  const Json json = kept("reference.json");
  if (json.is_null() || !std::filesystem::exists(plan_.folder / kReferencePicture)) {
    renderReference();
    return;
  }
  reference_ = readImage(plan_.folder / kReferencePicture);
  result_.reference_samples = json.at("samples");
  result_.reference_noise = json.at("noise");
  result_.reference_bounces = json.at("bounces");
}

void Measurement::demandSize() const {
  const RenderSettings& settings = plan_.variants.front().settings;
  if (reference_.width == settings.width && reference_.height == settings.height) return;
  throw Error(ErrorKind::input,
              fmt::format("{}: it has {}x{} pixels, and the pictures would have {}x{}; render it "
                          "with that size, or give --size",
                          printable(plan_.reference->string()), reference_.width, reference_.height,
                          settings.width, settings.height));
}

// What was asked for is what the others are compared with, and has the time of several of them.
double Measurement::secondsFor(const AccuracyVariant& variant) const {
  const double all = (1 - kReferenceShare) * plan_.seconds;
  const double shares = static_cast<double>(plan_.variants.size()) - 1 + kSharesAsAsked;
  // Compiling and building take their part.
  return std::max(0.75 * all * sharesOf(variant) / shares, 0.2);
}

void Measurement::addPoint(const AccuracyVariant& variant, double seconds, AccuracyCurve& curve) {
  const int samples = renderer_->samples();
  const Image image = renderer_->radiance();
  const double difference = differenceOf(image, reference_).noise;
  const double own = result_.reference_noise;
  if (difference < kLeastOfReference * own) return;
  const std::optional<NoiseEstimate> noise = renderer_->noiseNow();
  curve.points.push_back({samples, seconds, std::sqrt(difference * difference - own * own),
                          noise ? noise->relative : 0});
  if (variant.knob.empty()) writeImage(plan_.folder / pictureFile(variant.name(), samples), image);
}

AccuracyCurve Measurement::render(const AccuracyVariant& variant, double seconds) {
  renderer_->resize(variant.settings.width, variant.settings.height);
  renderer_->setLimits({variant.settings.bounces, variant.settings.clamp});
  renderer_->setSampler(variant.settings.sampler, variant.settings.seed);
  // The first sample after a change counts rays, and drivers warm up.
  renderer_->renderSample();
  renderer_->setSampler(variant.settings.sampler, variant.settings.seed);
  AccuracyCurve curve{variant.knob, variant.value, variant.options, 0, {}};
  double spent = 0;
  while (spent < seconds && renderer_->samples() < kMostSamples) {
    const Stopwatch clock;
    renderer_->renderSample();
    spent += clock.seconds();
    if (isPoint(renderer_->samples()) || spent >= seconds) addPoint(variant, spent, curve);
    show(fmt::format("{}, {} samples", variant.name(), renderer_->samples()));
  }
  if (curve.points.empty())
    throw Error(ErrorKind::failed,
                fmt::format("the reference is wrong by {} itself, which is too much to measure "
                            "'{}' against; give more --time, or a better --reference",
                            percent(result_.reference_noise), variant.name()));
  writeImage(plan_.folder / pictureFile(variant.name(), curve.points.back().samples),
             renderer_->radiance());
  return curve;
}

// Variants that leave out the same light share what that costs.
const LimitError& Measurement::limitsOf(const AccuracyVariant& variant, double noise) {
  const LightLimits limits{variant.settings.bounces, variant.settings.clamp};
  for (const auto& [known, error] : limits_)
    if (known.bounces == limits.bounces && known.clamp == limits.clamp) return error;
  show("what the limits leave out");
  limits_.emplace_back(limits, measureLimits(*renderer_, variant.settings, noise, kLimitSeconds));
  return limits_.back().second;
}

ErrorBudget errorBudgetOf(const Json& json) {
  return {json.at("samples"), json.at("noise"),    json.at("truncation"),    json.at("clamp"),
          json.at("limits"),  json.at("measured"), json.at("enough_bounces")};
}

void Measurement::measure(const AccuracyVariant& variant) {
  const bool first = variant.knob.empty();
  const Json json = kept(curveFile(variant.name()));
  if (!json.is_null()) {
    result_.curves.push_back(accuracyCurveOf(json.at("curve")));
    if (first && json.at("budget").is_object()) result_.budget = errorBudgetOf(json.at("budget"));
    return;
  }
  show(variant.name());
  makeRenderer(variant);
  AccuracyCurve curve = render(variant, secondsFor(variant));
  const LimitError& limits = limitsOf(variant, curve.points.back().noise);
  curve.stays = limits.both;
  if (first) result_.budget = budgetOf(curve, limits);
  keep(curveFile(variant.name()),
       {{"curve", jsonOf(curve)}, {"budget", first ? jsonOf(result_.budget) : Json()}});
  result_.curves.push_back(std::move(curve));
}

AccuracyResult Measurement::run() {
  takeReference();
  steps_done_ = kReferenceShare;
  for (const AccuracyVariant& variant : plan_.variants) {
    try {
      measure(variant);
    } catch (const Error& error) {
      // What the device does not have, such as OpenGL ES 3.0, is left out.
      const bool lacking = error.kind() == ErrorKind::usage || error.kind() == ErrorKind::no_gl;
      if (variant.knob.empty() || !lacking) throw;
    }
    steps_done_ += (1 - kReferenceShare) * sharesOf(variant) /
                   (static_cast<double>(plan_.variants.size()) - 1 + kSharesAsAsked);
  }
  if (!context_) context_.emplace(createOffscreenContext(plan_.backend, 2));
  result_.context = context_->info();
  return std::move(result_);
}

}  // namespace

Json jsonOf(const ErrorBudget& budget) {
  return {{"samples", budget.samples},
          {"noise", budget.noise},
          {"truncation", budget.truncation},
          {"clamp", budget.clamp},
          {"limits", budget.limits},
          {"measured", budget.measured},
          {"enough_bounces", budget.enough_bounces}};
}

AccuracyResult measureAccuracy(const AccuracyPlan& plan, const Scene& scene,
                               const AccuracyProgress& progress) {
  return Measurement(plan, scene, progress).run();
}

std::string pictureFile(const std::string& variant, int samples) {
  return fmt::format("{}-{}.pfm", fileNameOf(variant), samples);
}

}  // namespace glimt
