// Whether the noise that is claimed is the true one: renders a scene with many seeds, each until
// the noise of 10%, 5% and 2% is reached, and compares every picture with the mean of all the
// others'. Prints a row of a table for each goal, the first GOALS of them. The seeds are shared out
// among PROCESSES, so that a machine of many cores is done sooner.
// usage: noise_calibration SCENE SIDE SEEDS [GOALS [PROCESSES]]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include "renderer/core/image_difference.h"
#include "renderer/renderer.h"
#include "renderer/scene/load_scene.h"
#include "tests/bench/processes.h"

using namespace glimt;

namespace {

constexpr std::array kGoals{0.1, 0.05, 0.02};

// At an earlier number of samples: how many it was said to take for each goal.
struct Forecast {
  int samples = 0;
  std::array<double, kGoals.size()> wanted{};
};

struct Stop {
  NoiseEstimate claimed;
  Image picture;
};

struct Run {
  std::vector<Stop> stops;  // for each goal
  std::vector<Forecast> forecasts;
};

Run renderToGoals(Renderer& renderer, std::size_t goals) {
  Run run;
  std::size_t goal = 0;
  double next = 8;
  while (goal < goals) {
    renderer.renderSample();
    if (renderer.samples() < next) continue;
    next = 1.03 * renderer.samples();
    const NoiseEstimate noise = *renderer.noiseNow();
    Forecast forecast{noise.samples, {}};
    for (std::size_t i = 0; i < kGoals.size(); ++i)
      forecast.wanted[i] = noise.samplesFor(kGoals[i]);
    run.forecasts.push_back(forecast);
    for (; goal < goals && noise.upper <= kGoals[goal]; ++goal)
      run.stops.push_back({noise, renderer.radiance()});
  }
  return run;
}

Image sumOfLast(const std::vector<Run>& runs) {
  Image sum = runs.front().stops.back().picture;
  for (std::size_t k = 1; k < runs.size(); ++k)
    for (std::size_t i = 0; i < sum.pixels.size(); ++i)
      sum.pixels[i] += runs[k].stops.back().picture.pixels[i];
  return sum;
}

// The mean of all others.
Image without(const Image& sum, const Image& own, std::size_t runs) {
  Image mean = sum;
  for (std::size_t i = 0; i < sum.pixels.size(); ++i)
    mean.pixels[i] = (sum.pixels[i] - own.pixels[i]) / static_cast<float>(runs - 1);
  return mean;
}

// The pictures' noise, squared, against a reference of the same kind: what that itself adds is the
// part `of_reference`.
std::vector<double> squaredNoise(const std::vector<Run>& runs, const Image& sum, std::size_t goal) {
  std::vector<double> squares;
  for (const Run& run : runs) {
    const Image reference = without(sum, run.stops.back().picture, runs.size());
    squares.push_back(std::pow(differenceOf(run.stops[goal].picture, reference).noise, 2));
  }
  return squares;
}

double meanOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// The share of forecasts, made between a twentieth and nine tenths of the way, that were within a
// fifth of the samples it took.
double forecastsWithin(const std::vector<Run>& runs, std::size_t goal) {
  int all = 0;
  int good = 0;
  for (const Run& run : runs)
    for (const Forecast& forecast : run.forecasts) {
      const int took = run.stops[goal].claimed.samples;
      if (forecast.samples < 0.05 * took || forecast.samples > 0.9 * took) continue;
      ++all;
      if (std::abs(forecast.wanted[goal] / took - 1) <= 0.2) ++good;
    }
  return all == 0 ? 1 : static_cast<double>(good) / all;
}

void printRows(const std::string& name, const std::vector<Run>& runs) {
  const Image sum = sumOfLast(runs);
  const std::size_t goals = runs.front().stops.size();
  const double of_reference =
      meanOf(squaredNoise(runs, sum, goals - 1)) / static_cast<double>(runs.size());
  for (std::size_t goal = 0; goal < goals; ++goal) {
    const std::vector<double> squares = squaredNoise(runs, sum, goal);
    int below = 0;
    std::vector<double> ratios, samples;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      const double truth = std::sqrt(std::max(squares[k] - of_reference, 0.0));
      const NoiseEstimate& claimed = runs[k].stops[goal].claimed;
      if (truth <= claimed.upper) ++below;
      ratios.push_back(claimed.relative / truth);
      samples.push_back(claimed.samples);
    }
    fmt::print("| {} | {:.0f}% | {:.0f} | {:.2f}% | {}/{} | {:.3f} | {:.0f}% |\n", name,
               100 * kGoals[goal], meanOf(samples),
               100 * std::sqrt(std::max(meanOf(squares) - of_reference, 0.0)), below, runs.size(),
               meanOf(ratios), 100 * forecastsWithin(runs, goal));
  }
}

template <class T>
void write(std::FILE* file, const T* values, std::size_t count) {
  if (std::fwrite(values, sizeof(T), count, file) != count)
    throw std::runtime_error("cannot write a temporary file");
}

template <class T>
void read(std::FILE* file, T* values, std::size_t count) {
  if (std::fread(values, sizeof(T), count, file) != count)
    throw std::runtime_error("a temporary file ends too early");
}

void writeRun(std::FILE* file, const Run& run) {
  for (const Stop& stop : run.stops) {
    write(file, &stop.claimed, 1);
    write(file, stop.picture.pixels.data(), stop.picture.pixels.size());
  }
  const std::size_t forecasts = run.forecasts.size();
  write(file, &forecasts, 1);
  write(file, run.forecasts.data(), forecasts);
}

Run readRun(std::FILE* file, int side, std::size_t goals) {
  Run run;
  for (std::size_t goal = 0; goal < goals; ++goal) {
    Stop stop{{}, {side, side, std::vector<Vec3>(static_cast<std::size_t>(side) * side)}};
    read(file, &stop.claimed, 1);
    read(file, stop.picture.pixels.data(), stop.picture.pixels.size());
    run.stops.push_back(std::move(stop));
  }
  std::size_t forecasts = 0;
  read(file, &forecasts, 1);
  run.forecasts.resize(forecasts);
  read(file, run.forecasts.data(), forecasts);
  return run;
}

struct Calibration {
  std::filesystem::path scene;
  int side = 0;
  int seeds = 0;
  std::size_t goals = kGoals.size();
  int processes = 1;
};

// Every `processes`-th seed from the first of the process on.
void renderShare(const Calibration& calibration, const Scene& scene, int process, std::FILE* file) {
  ContextHandle context = createOffscreenContext(Backend::automatic, 2);
  RenderSettings settings;
  settings.width = settings.height = calibration.side;
  settings.bounces = scene.render.bounces.value_or(settings.bounces);
  for (int seed = 1 + process; seed <= calibration.seeds; seed += calibration.processes) {
    settings.seed = static_cast<std::uint32_t>(seed);
    Renderer renderer(context, scene, settings);
    writeRun(file, renderToGoals(renderer, calibration.goals));
  }
}

void calibrate(const Calibration& calibration) {
  const Scene scene = loadScene(calibration.scene);
  const auto shares = inProcesses(calibration.processes, [&](int process, std::FILE* file) {
    renderShare(calibration, scene, process, file);
  });
  std::vector<Run> runs;
  for (int i = 0; i < calibration.seeds; ++i)
    runs.push_back(readRun(shares[static_cast<std::size_t>(i % calibration.processes)].get(),
                           calibration.side, calibration.goals));
  printRows(calibration.scene.stem().stem().string(), runs);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 4 || argc > 6)
      throw std::invalid_argument("usage: noise_calibration SCENE SIDE SEEDS [GOALS [PROCESSES]]");
    Calibration calibration{argv[1], std::atoi(argv[2]), std::atoi(argv[3])};
    if (argc > 4) calibration.goals = std::strtoul(argv[4], nullptr, 10);
    calibration.goals = std::clamp<std::size_t>(calibration.goals, 1, kGoals.size());
    if (argc > 5) calibration.processes = std::clamp(std::atoi(argv[5]), 1, calibration.seeds);
    calibrate(calibration);
  } catch (const std::exception& error) {
    fmt::print(stderr, "noise_calibration: {}\n", error.what());
    return 1;
  }
  return 0;
}
