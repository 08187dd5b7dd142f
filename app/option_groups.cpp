#include "app/option_groups.h"

#include <fmt/format.h>

#include <limits>

#include "app/parse.h"

namespace glimt {
namespace {

constexpr double kMostExposure = 64;

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

Backend backendNamed(const std::string& name) {
  if (name == "egl") return Backend::egl;
  return name == "osmesa" ? Backend::osmesa : Backend::automatic;
}

}  // namespace

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
  add(command, "--roulette", "on|off",
      "Whether paths that carry little light may end at random: faster, as exact in the mean (on)",
      [&](const std::string& text) {
        picture.roulette = parseChoice("--roulette", text, {"on", "off"}) == "on";
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

void addBackend(CLI::App& command, Backend& backend) {
  add(command, "--backend", "auto|egl|osmesa", "Where OpenGL comes from (auto)",
      [&](const std::string& text) {
        backend = backendNamed(parseChoice("--backend", text, {"auto", "egl", "osmesa"}));
      });
}

}  // namespace glimt
