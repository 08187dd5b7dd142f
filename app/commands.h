// The subcommands: what each one is asked, and what runs it. Each run returns the exit status.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/picture_settings.h"
#include "app/share/share.h"
#include "renderer/renderer.h"
#include "renderer/scene/load_scene.h"

namespace glimt {

struct RenderOptions {
  std::filesystem::path scene;
  LoadSettings load;
  std::vector<std::filesystem::path> outputs;
  PictureOptions picture;
  std::optional<int> samples;     // --spp
  std::optional<double> seconds;  // --time
  std::optional<double> noise;    // --noise, as a share of 1
  bool even = false;              // every pixel has all samples, also with a limit on the noise
  bool forecast = false;
  std::optional<SampleRange> share;  // --samples
  std::vector<std::string> layers;   // of .exr, see auxiliary_layers.h
  bool denoise = false;
  Backend backend = Backend::automatic;
  std::filesystem::path shader_folder;  // empty: they are not written
  std::string json;                     // a file, "-" for standard output, empty for none
  bool quiet = false;
  // More than one picture: `outputs` is then the folder that they go into.
  std::vector<std::string> variants;  // "all" alone: those that the scene has
  std::optional<int> angles;          // of a turntable

  bool isBatch() const { return !variants.empty() || angles.has_value(); }
};

struct ViewOptions {
  std::optional<std::filesystem::path> scene;
  LoadSettings load;
  PictureOptions picture;  // its size is the window's
  std::string json;        // how the window answered, written at the end
};

struct InfoOptions {
  std::filesystem::path scene;
  CameraOptions camera;  // its name alone
  LoadSettings load;
  std::string json;
};

struct CompareOptions {
  std::filesystem::path image;
  std::filesystem::path reference;
  std::filesystem::path output;     // of the difference as a picture; empty for none
  std::string metric = "flip";      // what the threshold is for
  std::optional<double> threshold;  // above it the exit status is 1
  std::string json;
};

enum class BenchSuite { traversal, passes, effects, device };

struct BenchOptions {
  BenchSuite suite = BenchSuite::traversal;
  std::filesystem::path scene;         // of suite effects; empty for its own
  std::vector<std::size_t> triangles;  // of the meshes; empty for the suite's own
  std::vector<int> bounces;            // of suites passes and effects; empty for their own
  int side = 512;                      // of the square of rays or pixels
  bool quick = false;
  int gles = 2;
  Backend backend = Backend::automatic;
  std::string json;
  std::filesystem::path chart;  // empty for none
};

struct AccuracyOptions {
  std::filesystem::path scene;
  LoadSettings load;
  std::filesystem::path folder;
  PictureOptions picture;
  // What was asked of the picture but its size, as on the command line: names and values.
  std::vector<std::pair<std::string, std::string>> arguments;
  std::optional<std::filesystem::path> reference;
  double seconds = 150;
  Backend backend = Backend::automatic;
  bool quiet = false;
};

struct DoctorOptions {
  int gles = 2;
  Backend backend = Backend::automatic;
  std::string json;
};

struct MergeOptions {
  std::vector<std::filesystem::path> shares;
  std::vector<std::filesystem::path> outputs;
  float exposure = 0;  // EV
  Tone tone = Tone::srgb;
  bool quiet = false;
};

struct BatchOptions {
  std::filesystem::path job;
  std::filesystem::path folder;  // empty: as the job says
  int part = 1;                  // of the job, from 1 to `parts`
  int parts = 1;
  bool quiet = false;
};

int runRender(const RenderOptions& options);
int runMerge(const MergeOptions& options);
int runBatch(const BatchOptions& options);
int runBatch(const RenderOptions& options);  // where isBatch()
int runView(const ViewOptions& options);
int runInfo(const InfoOptions& options);
int runCompare(const CompareOptions& options);
int runBench(const BenchOptions& options);
int runAccuracy(const AccuracyOptions& options);
int runDoctor(const DoctorOptions& options);

}  // namespace glimt
