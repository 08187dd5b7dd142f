// Options that several subcommands have.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>

#include "app/picture_settings.h"
#include "renderer/core/tone.h"

namespace glimt {

using Take = std::function<void(const std::string& text)>;

// An option with a value. CLI11's own number parsing reads 010 as eight and accepts 1e99 as an
// infinite float; `take` parses strictly instead.
CLI::Option* add(CLI::App& command, const std::string& name, const std::string& value,
                 const std::string& help, const Take& take);

void addScene(CLI::App& command, std::filesystem::path& scene);
void addVariant(CLI::App& command, LoadSettings& load);
void addJson(CLI::App& command, std::string& json);
void addGles(CLI::App& command, int& gles);
void addCameraName(CLI::App& command, std::string& name);
void addBackend(CLI::App& command, Backend& backend);

// `otherwise` says what is taken where the option is not given.
void addExposure(CLI::App& command, const std::string& otherwise,
                 const std::function<void(float)>& take);
void addTone(CLI::App& command, const std::string& otherwise,
             const std::function<void(Tone)>& take);

void addPicture(CLI::App& command, PictureOptions& picture);

// What only pictures that are kept are asked for.
void addSampling(CLI::App& command, PictureOptions& picture);

}  // namespace glimt
