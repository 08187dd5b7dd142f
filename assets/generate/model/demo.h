// A demo: a model, and the scene file that photographs it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "assets/generate/model/model.h"

namespace glimt::assets {

struct Demo {
  std::string name;
  Model model;
  nlohmann::ordered_json scene;  // of the scene file, without "model"
};

// Writes FOLDER/NAME.scene.json and the model beside it. Errors: failed.
void writeDemo(const std::filesystem::path& folder, const Demo& demo);

}  // namespace glimt::assets
