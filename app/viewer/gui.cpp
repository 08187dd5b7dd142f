#include "app/viewer/gui.h"

#include <backends/imgui_impl_glfw.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace glimt {
namespace {

constexpr float kFontSize = 15;

// A font that is easier on the eyes than the one that comes with ImGui, where it is installed.
constexpr std::array kFonts{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                            "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"};

void loadFont(float scale) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  std::error_code ignored;
  for (const char* const file : kFonts)
    if (std::filesystem::exists(file, ignored) &&
        fonts.AddFontFromFileTTF(file, std::round(kFontSize * scale)) != nullptr)
      return;
  ImFontConfig config;
  config.SizePixels = std::round(13 * scale);
  fonts.AddFontDefault(&config);
}

void setStyle(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.FrameRounding = 3;
  style.WindowBorderSize = 0;
  style.WindowPadding = {12, 10};
  style.ItemSpacing = {8, 5};
  style.CellPadding = {8, 3};
  style.Colors[ImGuiCol_WindowBg] = {0.09f, 0.09f, 0.10f, 1};
  style.Colors[ImGuiCol_TextDisabled] = {0.62f, 0.63f, 0.66f, 1};
  style.Colors[ImGuiCol_Header] = {0.18f, 0.19f, 0.22f, 1};
  style.Colors[ImGuiCol_FrameBg] = {0.19f, 0.20f, 0.23f, 1};
  style.Colors[ImGuiCol_Button] = {0.22f, 0.28f, 0.38f, 1};
  style.ScaleAllSizes(scale);
}

}  // namespace

Gui::Library::Library(Window& window) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  loadFont(window.scale());
  setStyle(window.scale());
  ImGui_ImplGlfw_InitForOpenGL(window.get(), false);
}

Gui::Library::~Library() {
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

Gui::Gui(Window& window)
    : window_(window), context_(gl::adoptContext(window.loader())), library_(window) {
  renderer_.emplace(context_->functions());
}

Gui::~Gui() = default;

void Gui::beginFrame() {
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Gui::endFrame() {
  ImGui::Render();
  renderer_->draw(*ImGui::GetDrawData());
  window_.swapBuffers();
}

bool Gui::wantsKeys() const {
  return ImGui::GetIO().WantTextInput;
}

}  // namespace glimt
