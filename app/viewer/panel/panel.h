// The panel over the picture: what it is told, and what comes back. One file draws one section.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/beside_work.h"
#include "app/viewer/loaded_scene.h"
#include "app/viewer/noise_history.h"
#include "app/viewer/orbit_camera.h"
#include "app/viewer/viewer_state.h"
#include "app/viewer/window_picture.h"

namespace glimt {

// How the window answers.
struct WindowPace {
  double frames_per_second = 0;  // while something moves
  double latency = 0;            // seconds from an event to the picture that shows it
};

struct PanelData {
  const LoadedScene* scene = nullptr;  // null while there is none
  const Camera& camera;
  const PictureStatus& status;
  const ContextInfo& device;
  const std::string& record;  // how hits are kept
  const NoiseHistory& noise;
  const std::vector<std::filesystem::path>& recent;
  std::array<int, 2> size{1, 1};  // of the picture, in pixels
  WindowPace pace;
  std::optional<LimitError> limits;
  bool measuring_limits = false;
  const std::optional<EffectCosts>& effect_costs;
  bool measuring_effects = false;
  std::optional<float> saving;  // how far a picture in the background is
  bool comparing = false;
  bool can_undo = false;
  bool can_redo = false;
};

// A picture that is made beside the window.
struct SavedPicture {
  std::filesystem::path file;
  std::array<int, 2> size{1, 1};
  int samples = 1;
};

// What the user asks for, that is more than an edit.
struct PanelWishes {
  std::optional<std::filesystem::path> open;
  std::optional<std::string> variant;
  std::optional<std::size_t> camera;       // into Scene::cameras
  std::optional<Lens> lens;                // another one for the camera
  std::optional<std::string> environment;  // by its name; empty: the file's own
  std::optional<SavedPicture> save_picture;
  bool save_scene = false;
  bool copy_command = false;
  bool measure_limits = false;
  bool measure_effects = false;
  bool cancel_saving = false;
  bool undo = false;
  bool redo = false;
  bool compare = false;  // begins, or ends
  bool frame = false;
  bool reset = false;
};

// What the panel's fields hold while they are typed into.
struct PanelFields {
  std::array<char, 1024> path{};
  std::array<char, 1024> picture{"picture.png"};
  std::array<int, 2> picture_size{1920, 1080};
  int picture_samples = 256;
  bool typing_path = false;  // the field of the path is to take the keys
};

// Of a window of that width.
float panelWidth(float window_width);

PanelWishes drawPanel(const PanelData& data, ViewerState& state, PanelFields& fields);

// F1: the keys.
void drawHelp(bool& shown);

// What is being done, and what went wrong.
struct NoticeData {
  float left = 0;  // where the picture begins, as a share of the window's width
  std::string message;
  bool failure = false;
  std::string preparing;  // empty: nothing is
  std::string loading;    // the file; empty: none is
  float progress = 0;     // of loading
  bool can_cancel = false;
};

// Over the picture. Whether loading is to be cancelled.
bool drawNotice(const NoticeData& notice);

// --- The sections ----------------------------------------------------------------------------

void drawPictureSection(const PanelData& data, ViewerState& state);
void drawNoiseCurve(const NoiseHistory& noise, float goal);
void drawAccuracySection(const PanelData& data, ViewerState& state, PanelWishes& wishes);
void drawLightSection(const PanelData& data, ViewerState& state, PanelWishes& wishes);
void drawMaterialSection(const PanelData& data, ViewerState& state);
void drawVariantSection(const PanelData& data, ViewerState& state, PanelWishes& wishes);
void drawCameraSection(const PanelData& data, ViewerState& state, PanelWishes& wishes);
void drawFileSection(const PanelData& data, PanelFields& fields, PanelWishes& wishes);
void drawSceneSection(const PanelData& data);
void drawEffectsSection(const PanelData& data, PanelWishes& wishes);
void drawDeviceSection(const PanelData& data);

// A name and what it is, in two columns.
void drawRow(const char* name, const std::string& value);

// For the control that follows: writes its name, which is what follows the "##" of its ImGui id,
// into the left column, and gives it the right one. Returns the id.
const char* named(const char* id);

}  // namespace glimt
