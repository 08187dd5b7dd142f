// What was changed in the window, as a scene file.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "app/json_output.h"
#include "app/viewer/loaded_scene.h"
#include "app/viewer/look.h"

namespace glimt {

struct EditedScene {
  Json file;
  std::vector<std::string> warnings;  // what a scene file cannot say
};

// A scene file that renders as the look does from that camera; it belongs beside the file that is
// open. Of a scene file that is open it keeps what was not changed. Errors: input, where that
// cannot be read any more.
EditedScene editedScene(const LoadedScene& loaded, const Look& look, const Camera& camera,
                        std::array<int, 2> size);

// Whether the command line of glimt render can say all that differs from the file.
bool fitsCommandLine(const LoadedScene& loaded, const Look& look, const Camera& camera);

// A name beside the file that is open, which is not taken: NAME.scene.json of a model,
// NAME-edited.scene.json of a scene file, or with numbers.
std::filesystem::path editedSceneName(const std::filesystem::path& open);

}  // namespace glimt
