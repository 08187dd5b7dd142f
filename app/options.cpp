#include "app/options.h"

#include <algorithm>
#include <limits>

#include "app/auxiliary_layers.h"
#include "app/batch/batch_job.h"
#include "app/commands.h"
#include "app/option_groups.h"
#include "app/parse.h"
#include "renderer/core/error.h"

namespace glimt {
namespace {

// Between the least tube that is still round and what fits into a texture.
constexpr std::int64_t kLeastBenchTriangles = 100;
constexpr std::int64_t kMostBenchTriangles = 2700000;
constexpr std::int64_t kMostBenchSide = 4096;

void addLimits(CLI::App& command, RenderOptions& options) {
  add(command, "--spp", "N",
      "End after N samples per pixel (256, unless --time or --noise is given)",
      [&](const std::string& text) {
        options.samples = static_cast<int>(
            parseInteger("--spp", text, 1, std::numeric_limits<std::int32_t>::max()));
      });
  add(command, "--time", "S", "End after S seconds of rendering", [&](const std::string& text) {
    options.seconds = parseNumberBetween("--time", text, 0, 1e9);
  });
  add(command, "--noise", "PCT",
      "End when the noise is below PCT percent of the picture, with 95% confidence",
      [&](const std::string& text) { options.noise = 0.01 * parsePercent("--noise", text); });
  command.add_flag("--even", options.even,
                   "With --noise: as many samples everywhere, instead of where the noise is");
}

BenchSuite suiteNamed(const std::string& name) {
  parseChoice("--suite", name, {"traversal", "passes", "effects", "device"});
  if (name == "device") return BenchSuite::device;
  if (name == "effects") return BenchSuite::effects;
  return name == "passes" ? BenchSuite::passes : BenchSuite::traversal;
}

// Whole numbers with commas between them.
template <typename Number>
std::vector<Number> parseList(const std::string& option, const std::string& text,
                              std::int64_t least, std::int64_t most) {
  std::vector<Number> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    numbers.push_back(
        static_cast<Number>(parseInteger(option, text.substr(begin, end - begin), least, most)));
    begin = end + 1;
  }
  return numbers;
}

// The options that were given and that glimt render takes too, but for those of a report.
std::vector<std::pair<std::string, std::string>> repeated(const CLI::App& command) {
  const std::vector<std::string> own{"--output", "--time", "--reference", "--size", "--quiet"};
  std::vector<std::pair<std::string, std::string>> given;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    const bool taken = option->count() > 0 && name.starts_with("--") &&
                       std::find(own.begin(), own.end(), name) == own.end();
    if (taken) given.emplace_back(name, option->results()[0]);
  }
  return given;
}

// What makes a batch of a render.
void addSeries(CLI::App& command, RenderOptions& options) {
  CLI::Option* const variants =
      add(command, "--variants", "all|NAME[,NAME...]",
          "A picture of each of these variants, into the folder -o; see glimt batch",
          [&](const std::string& text) { options.variants = parseNames("--variants", text); });
  variants->excludes(command.get_option("--variant"));
  CLI::Option* const turntable =
      add(command, "--turntable", "N", "A picture from each of N sides, into the folder -o",
          [&](const std::string& text) {
            options.angles = static_cast<int>(parseInteger("--turntable", text, 1, kMostAngles));
          });
  for (const char* const other :
       {"--forecast", "--samples", "--layers", "--json", "--dump-shaders"}) {
    variants->excludes(command.get_option(other));
    turntable->excludes(command.get_option(other));
  }
}

}  // namespace

void addRenderOptions(CLI::App& command, RenderOptions& options) {
  addScene(command, options.scene);
  addVariant(command, options.load);
  command
      .add_option("-o,--output", options.outputs,
                  "Picture to write, .png .exr .pfm or .hdr; may be given several times")
      ->type_name("FILE")
      ->allow_extra_args(false);
  addLimits(command, options);
  command.add_flag("--forecast", options.forecast,
                   "Say what noise of 10% to 0.5% takes, and end; no picture is needed");
  command.callback([&] {
    if (options.outputs.empty() && !options.forecast)
      throw Error(ErrorKind::usage, "no picture to write; name one with -o, like -o picture.png");
  });
  add(command, "--samples", "FIRST:COUNT",
      "Make these samples alone, as a share for glimt merge; into an .exr",
      [&](const std::string& text) {
        const auto [first, count] = parseSamples("--samples", text);
        options.share = SampleRange{first, count};
      })
      ->excludes(command.get_option("--spp"))
      ->excludes(command.get_option("--time"))
      ->excludes(command.get_option("--noise"))
      ->excludes(command.get_option("--forecast"));
  add(command, "--layers", "all|NAME[,NAME...]",
      "Also write these into an .exr: albedo, normal, depth, material, noise, cost",
      [&](const std::string& text) {
        options.layers = parseChoices("--layers", text, {kLayerNames.begin(), kLayerNames.end()});
      });
  command
      .add_flag("--denoise", options.denoise,
                "Take noise out of the picture, for previews; its file says so (docs/denoiser.md)")
      ->excludes(command.get_option("--samples"));
  addPicture(command, options.picture);
  addBackend(command, options.backend);
  addSampling(command, options.picture);
  addJson(command, options.json);
  command
      .add_option("--dump-shaders", options.shader_folder,
                  "Write the shaders that the scene calls for into this folder")
      ->type_name("DIR");
  command.add_flag("--quiet", options.quiet, "Say nothing but errors");
  addSeries(command, options);
}

void addMergeOptions(CLI::App& command, MergeOptions& options) {
  command.add_option("SHARE", options.shares, "Pictures that glimt render --samples made, .exr")
      ->type_name("...")
      ->required();
  command
      .add_option("-o,--output", options.outputs,
                  "Picture to write; an .exr is a share again; may be given several times")
      ->type_name("FILE")
      ->required()
      ->allow_extra_args(false);
  addExposure(command, "0", [&](float exposure) { options.exposure = exposure; });
  addTone(command, "srgb", [&](Tone tone) { options.tone = tone; });
  command.add_flag("--quiet", options.quiet, "Say nothing but errors");
}

void addBatchOptions(CLI::App& command, BatchOptions& options) {
  command.add_option("JOB", options.job, "A .json that says which pictures of what; docs/batch.md")
      ->type_name("")
      ->required();
  command
      .add_option("-o,--output", options.folder,
                  "Folder of the pictures (the job's, else one of its name beside it)")
      ->type_name("DIR");
  add(command, "--job-part", "I/N",
      "Make the Ith of N parts alone; afterwards, without it, the whole manifest",
      [&](const std::string& text) {
        const auto [part, parts] = parsePart("--job-part", text);
        options.part = part;
        options.parts = parts;
      });
  command.add_flag("--quiet", options.quiet, "Say nothing but errors");
}

void addViewOptions(CLI::App& command, ViewOptions& options) {
  add(command, "SCENE", "", "A .scene.json, .obj, .gltf or .glb (the one that comes with glimt)",
      [&](const std::string& text) { options.scene = text; });
  addVariant(command, options.load);
  addPicture(command, options.picture);
  command.add_option("--json", options.json, "Write how the window answered, at the end")
      ->type_name("FILE");
}

void addInfoOptions(CLI::App& command, InfoOptions& options) {
  addScene(command, options.scene);
  addCameraName(command, options.camera.name);
  addVariant(command, options.load);
  addJson(command, options.json);
}

void addCompareOptions(CLI::App& command, CompareOptions& options) {
  command.add_option("A", options.image, "The picture to judge")->type_name("")->required();
  command.add_option("B", options.reference, "What it should look like")->type_name("")->required();
  command.add_option("-o,--output", options.output, "Where they differ, as a .png")
      ->type_name("FILE");
  add(command, "--threshold", "X", "Exit with 1 where the difference is above X",
      [&](const std::string& text) {
        options.threshold = parseNumberBetween("--threshold", text, -1e-300, 1e30);
      });
  add(command, "--metric", "flip|relmse|mse|noise", "Which difference that is (flip)",
      [&](const std::string& text) {
        options.metric = parseChoice("--metric", text, {"flip", "relmse", "mse", "noise"});
      });
  addJson(command, options.json);
}

void addBenchOptions(CLI::App& command, BenchOptions& options) {
  command.add_option("SCENE", options.scene, "For suite effects (a box)")->type_name("");
  add(command, "--suite", "traversal|passes|effects|device", "What to measure (traversal)",
      [&](const std::string& text) { options.suite = suiteNamed(text); });
  add(command, "--triangles", "N[,N...]",
      "Sizes of the meshes (traversal: 1000,70000,500000,2000000, passes: 70000)",
      [&](const std::string& text) {
        options.triangles =
            parseList<std::size_t>("--triangles", text, kLeastBenchTriangles, kMostBenchTriangles);
      });
  add(command, "--bounces", "N[,N...]",
      "Secondary bounces (passes: 1,2,3,4,5,6,7,8, effects: as for a picture)",
      [&](const std::string& text) {
        options.bounces = parseList<int>("--bounces", text, 0, kMostBounces);
      });
  add(command, "--side", "N", "Rays or pixels along a side of the square (512)",
      [&](const std::string& text) {
        options.side = static_cast<int>(parseInteger("--side", text, 1, kMostBenchSide));
      });
  command.add_flag("--quick", options.quick,
                   "The two smallest meshes, or 1, 2, 4 and 8 bounces, or the smallest pictures; "
                   "fewer repeats");
  addGles(command, options.gles);
  addBackend(command, options.backend);
  addJson(command, options.json);
  command.add_option("--chart", options.chart, "Draw the results as SVG")->type_name("FILE");
}

void addAccuracyOptions(CLI::App& command, AccuracyOptions& options) {
  addScene(command, options.scene);
  addVariant(command, options.load);
  command.add_option("-o,--output", options.folder, "Folder of the report")
      ->type_name("DIR")
      ->required();
  addPicture(command, options.picture);
  addSampling(command, options.picture);
  add(command, "--time", "S", "Take about S seconds for all of it (150)",
      [&](const std::string& text) {
        options.seconds = parseNumberBetween("--time", text, 0, 1e6);
      });
  add(command, "--reference", "FILE", "A converged picture to measure against (renders one)",
      [&](const std::string& text) { options.reference = text; });
  addBackend(command, options.backend);
  command.add_flag("--quiet", options.quiet, "Say nothing but errors");
  command.callback([&] { options.arguments = repeated(command); });
}

void addDoctorOptions(CLI::App& command, DoctorOptions& options) {
  addGles(command, options.gles);
  addBackend(command, options.backend);
  addJson(command, options.json);
}

}  // namespace glimt
