// A demo: a model, the scene file that photographs it, and a job of many such photographs.
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
  nlohmann::ordered_json
      batch;  // of the job for glimt batch, without "scene"; null where there is none
};

// Writes FOLDER/NAME.scene.json, the model beside it, and NAME.batch.json. Errors: failed.
void writeDemo(const std::filesystem::path& folder, const Demo& demo);

}  // namespace glimt::assets
