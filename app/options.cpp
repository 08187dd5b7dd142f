#include "app/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "app/auxiliary_layers.h"
#include "app/commands.h"
#include "app/parse.h"
#include "renderer/core/error.h"
#include "renderer/core/wording.h"
#include "renderer/scene/default_bounces.h"
#include "renderer/scene/effects_of.h"
#include "renderer/scene/framing.h"

namespace glimt {
namespace {

constexpr double kMostExposure = 64;
// Between the least tube that is still round and what fits into a texture.
constexpr std::int64_t kLeastBenchTriangles = 100;
constexpr std::int64_t kMostBenchTriangles = 2700000;
constexpr std::int64_t kMostBenchSide = 4096;

using Take = std::function<void(const std::string& text)>;

// An option with a value. CLI11's own number parsing reads 010 as eight and accepts 1e99 as an
// infinite float; `take` parses strictly instead.
CLI::Option* add(CLI::App& command, const std::string& name, const std::string& value,
                 const std::string& help, const Take& take) {
  return command.add_option_function<std::string>(name, take, help)->type_name(value);
}

void addScene(CLI::App& command, std::filesystem::path& scene) {
  command.add_option("SCENE", scene, "A .scene.json, .obj, .gltf or .glb")
      ->type_name("")
      ->required();
}

void addVariant(CLI::App& command, LoadSettings& load) {
  command.add_option("--variant", load.variant, "One of the scene's variants of materials")
      ->type_name("NAME");
}

void addJson(CLI::App& command, std::string& json) {
  command.add_option("--json", json, "Write a report as JSON; - is standard output")
      ->type_name("FILE");
}

void addGles(CLI::App& command, int& gles) {
  add(command, "--gles", "2|3", "OpenGL ES version to ask for (2)", [&](const std::string& text) {
    gles = parseChoice("--gles", text, {"2", "3"}) == "2" ? 2 : 3;
  });
}

void addCameraName(CLI::App& command, std::string& name) {
  command.add_option("--camera", name, "One of the scene's cameras")->type_name("NAME");
}

void addEnvironment(CLI::App& command, EnvironmentChoice& environment) {
  add(command, "--environment", "NAME|FILE",
      "Light from outside: studio, sun-sky or a picture (the scene's)",
      [&](const std::string& text) { environment.image = text; });
  add(command, "--environment-rotation", "DEG", "Turns it about +y", [&](const std::string& text) {
    environment.rotation = static_cast<float>(parseNumber("--environment-rotation", text));
  });
  add(command, "--environment-strength", "X", "Multiplies its light", [&](const std::string& text) {
    environment.strength =
        static_cast<float>(parseNumberBetween("--environment-strength", text, -1e-9, 1e9));
  });
}

void addCamera(CLI::App& command, CameraOptions& camera) {
  addCameraName(command, camera.name);
  CLI::Option* const name = command.get_option("--camera");
  add(command, "--eye", "X,Y,Z", "Where the camera is", [&](const std::string& text) {
    camera.eye = parseVector("--eye", text);
  })->excludes(name);
  add(command, "--target", "X,Y,Z", "What the camera looks at", [&](const std::string& text) {
    camera.target = parseVector("--target", text);
  })->excludes(name);
  add(command, "--up", "X,Y,Z", "The camera's upward direction", [&](const std::string& text) {
    camera.up = Vec3(parseVector("--up", text));
  })->excludes(name);
  add(command, "--fov", "DEG", "Degrees over the picture's height", [&](const std::string& text) {
    camera.vertical_fov = static_cast<float>(parseNumberBetween("--fov", text, 0, 180));
  })->excludes(name);
}

void addExposure(CLI::App& command, const std::string& otherwise,
                 const std::function<void(float)>& take) {
  add(command, "--exposure", "EV", fmt::format("Brightens the display by 2^EV ({})", otherwise),
      [take](const std::string& text) {
        take(static_cast<float>(
            parseNumberBetween("--exposure", text, -kMostExposure, kMostExposure)));
      });
}

void addTone(CLI::App& command, const std::string& otherwise,
             const std::function<void(Tone)>& take) {
  add(command, "--tone", "srgb|agx|aces",
      fmt::format("How light becomes the display's: clipped, or by a curve ({})", otherwise),
      [take](const std::string& text) {
        take(toneNamed(parseChoice("--tone", text, {kToneNames.begin(), kToneNames.end()})));
      });
}

void addPicture(CLI::App& command, PictureOptions& picture) {
  add(command, "--size", "WxH", "Width and height in pixels (the scene's, else 512x512)",
      [&](const std::string& text) { picture.size = parseSize("--size", text); });
  add(command, "--bounces", "N",
      "Secondary bounces (the scene's, else 4, or 8 with mirrors or glass)",
      [&](const std::string& text) {
        picture.bounces = static_cast<int>(parseInteger("--bounces", text, 0, kMostBounces));
      });
  addCamera(command, picture.camera);
  addEnvironment(command, picture.environment);
  addExposure(command, "the scene's, else 0", [&](float exposure) { picture.exposure = exposure; });
  addTone(command, "the scene's, else srgb", [&](Tone tone) { picture.tone = tone; });
  add(command, "--seed", "N", "Another seed, another noise (0)", [&](const std::string& text) {
    picture.seed = static_cast<std::uint32_t>(
        parseInteger("--seed", text, 0, std::numeric_limits<std::uint32_t>::max()));
  });
  command.add_option("--traversal", picture.traversal, "How rays find triangles (auto)")
      ->type_name("NAME");
  addGles(command, picture.gles);
}

// What only pictures that are kept are asked for.
void addSampling(CLI::App& command, PictureOptions& picture) {
  add(command, "--record", "packed|wide", "How hits are stored (packed)",
      [&](const std::string& text) {
        picture.record = parseChoice("--record", text, {"packed", "wide"});
      });
  add(command, "--sampler", "sobol|random", "Where random numbers come from (sobol)",
      [&](const std::string& text) {
        const bool random = parseChoice("--sampler", text, {"sobol", "random"}) == "random";
        picture.sampler = random ? Sampler::random : Sampler::sobol;
      });
  add(command, "--background", "scene|transparent",
      "What is behind the scene: its environment, or nothing, as alpha in .png and .exr (scene)",
      [&](const std::string& text) {
        picture.transparent_background =
            parseChoice("--background", text, {"scene", "transparent"}) == "transparent";
      });
  add(command, "--clamp", "X",
      "Dim samples of a luminance above X: fewer specks, and less light (never)",
      [&](const std::string& text) {
        picture.clamp = static_cast<float>(parseNumberBetween("--clamp", text, 0, 1e9));
      });
}

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

Backend backendNamed(const std::string& name) {
  if (name == "egl") return Backend::egl;
  return name == "osmesa" ? Backend::osmesa : Backend::automatic;
}

void addBackend(CLI::App& command, Backend& backend) {
  add(command, "--backend", "auto|egl|osmesa", "Where OpenGL comes from (auto)",
      [&](const std::string& text) {
        backend = backendNamed(parseChoice("--backend", text, {"auto", "egl", "osmesa"}));
      });
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

Camera cameraNamed(const std::string& name, const Scene& scene) {
  std::vector<std::string> names;
  for (const NamedCamera& named : scene.cameras) {
    if (named.name == name) return named.camera;
    names.push_back(named.name);
  }
  throw Error(ErrorKind::usage,
              fmt::format("the scene has no camera named '{}'; {}", printable(name),
                          names.empty() ? "use --eye, --target, --up and --fov"
                                        : "it has " + listed(names)));
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
  addPicture(command, options.picture);
  addBackend(command, options.backend);
  addSampling(command, options.picture);
  addJson(command, options.json);
  command
      .add_option("--dump-shaders", options.shader_folder,
                  "Write the shaders that the scene calls for into this folder")
      ->type_name("DIR");
  command.add_flag("--quiet", options.quiet, "Say nothing but errors");
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
  addPicture(command, options.picture);
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

Camera cameraOf(const CameraOptions& options, const Scene& scene) {
  if (!options.name.empty()) return cameraNamed(options.name, scene);
  Camera camera = scene.camera;
  // Where the lens is sharp at the target it stays so.
  const float before = glm::distance(camera.position, camera.target);
  const bool at_target = std::abs(camera.focus_distance - before) <= 1e-5f * before;
  if (options.eye) camera.position = Vec3(*options.eye - scene.origin);
  if (options.target) camera.target = Vec3(*options.target - scene.origin);
  camera.up = options.up ? *options.up : usableUp(camera);
  camera.vertical_fov = options.vertical_fov.value_or(camera.vertical_fov);

  const Vec3 forward = camera.target - camera.position;
  if (at_target) camera.focus_distance = glm::length(forward);
  if (!(glm::length(forward) > 0)) {
    throw Error(ErrorKind::usage, "the camera is at its target; move --eye or --target");
  }
  const Vec3 side = glm::cross(forward, camera.up);
  if (!(glm::length(side) > 1e-6f * glm::length(forward) * glm::length(camera.up))) {
    throw Error(ErrorKind::usage, "the camera's up is along its view; give another --up");
  }
  return camera;
}

RenderSettings settingsOf(const PictureOptions& options, const Scene& scene) {
  const auto [width, height] =
      options.size.value_or(scene.render.size.value_or(std::array{512, 512}));
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.bounces = options.bounces.value_or(
      scene.render.bounces.value_or(defaultBounces(effectsOf(scene)).bounces));
  settings.seed = options.seed;
  settings.traversal = options.traversal;
  settings.record = options.record;
  settings.sampler = options.sampler;
  settings.clamp = options.clamp;
  return settings;
}

float exposureOf(const PictureOptions& options, const Scene& scene) {
  return options.exposure.value_or(scene.render.exposure.value_or(0.0f));
}

Tone toneOf(const PictureOptions& options, const Scene& scene) {
  return options.tone.value_or(scene.render.tone.value_or(Tone::srgb));
}

}  // namespace glimt
