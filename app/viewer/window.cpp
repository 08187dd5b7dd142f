#include "app/viewer/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "renderer/core/error.h"

namespace glimt {
namespace {

[[noreturn]] void failToOpen() {
  const char* reason = nullptr;
  glfwGetError(&reason);
  throw Error(ErrorKind::no_gl,
              fmt::format("cannot open a window ({}); use glimt render where there is no display",
                          reason != nullptr ? reason : "no reason given"));
}

void hint(int context_api, bool scaled) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, context_api);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
  // The picture is opaque and flat.
  glfwWindowHint(GLFW_ALPHA_BITS, 0);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, scaled ? GLFW_TRUE : GLFW_FALSE);
}

std::array<int, 2> fittedToMonitor(std::array<int, 2> size) {
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return size;
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  if (width <= 0 || height <= 0) return size;
  const double scale =
      std::min({1.0, static_cast<double>(width) / size[0], static_cast<double>(height) / size[1]});
  const auto scaled = [&](int side) { return std::max(1, static_cast<int>(side * scale)); };
  return {scaled(size[0]), scaled(size[1])};
}

// Pixels that the mouse may move while a button is down for it to be a click.
constexpr float kMostOfClick = 4;
constexpr double kDoubleClickSeconds = 0.35;

std::optional<KeyPress> keyNamed(int key, std::string_view letter) {
  constexpr std::array<std::pair<int, Key>, 4> kKeys{{{GLFW_KEY_ESCAPE, Key::escape},
                                                      {GLFW_KEY_TAB, Key::tab},
                                                      {GLFW_KEY_F1, Key::f1},
                                                      {GLFW_KEY_SPACE, Key::space}}};
  constexpr std::array<std::pair<char, Key>, 9> kLetters{{{'c', Key::c},
                                                          {'d', Key::d},
                                                          {'f', Key::f},
                                                          {'o', Key::o},
                                                          {'r', Key::r},
                                                          {'s', Key::s},
                                                          {'t', Key::t},
                                                          {'y', Key::y},
                                                          {'z', Key::z}}};
  for (const auto& [number, named] : kKeys)
    if (key == number) return KeyPress{named};
  if (letter.size() != 1) return {};
  for (const auto& [character, named] : kLetters)
    if (letter[0] == character) return KeyPress{named};
  if (letter[0] >= '1' && letter[0] <= '9') return KeyPress{Key::digit, letter[0] - '0'};
  return {};
}

Window& windowOf(GLFWwindow* window) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

}  // namespace

Window::Library::Library() {
  if (glfwInit() != GLFW_TRUE) failToOpen();
}

Window::Library::~Library() {
  glfwTerminate();
}

void Window::Destroy::operator()(GLFWwindow* window) const {
  glfwDestroyWindow(window);
}

Window::Window(std::array<int, 2> size, bool scaled, const std::string& title) {
  // Where EGL has no way to a window, GLX, WGL or NSGL may still make an ES context.
  for (const int context_api : {GLFW_EGL_CONTEXT_API, GLFW_NATIVE_CONTEXT_API}) {
    hint(context_api, scaled);
    open(size, title);
    if (window_) break;
  }
  if (!window_) failToOpen();
  glfwMakeContextCurrent(window_.get());
  // What is drawn is paced by the viewer; waiting for the display would take time from sampling.
  glfwSwapInterval(0);
  installCallbacks();
}

Window::~Window() = default;

void Window::open(std::array<int, 2> size, const std::string& title) {
  const auto [width, height] = fittedToMonitor(size);
  window_.reset(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
}

// Each tells the user interface first, which keeps what it needs to know.
void Window::installCallbacks() {
  GLFWwindow* const window = window_.get();
  glfwSetWindowUserPointer(window, this);
  glfwSetCursorPosCallback(
      window, [](GLFWwindow* w, double x, double y) { windowOf(w).onCursor(Vec2(x, y)); });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
    ImGui_ImplGlfw_MouseButtonCallback(w, button, action, modifiers);
    windowOf(w).onButton(button, action == GLFW_PRESS, modifiers);
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    ImGui_ImplGlfw_ScrollCallback(w, x, y);
    windowOf(w).onWheel(static_cast<float>(y));
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
    windowOf(w).active_ = true;
    if (action == GLFW_RELEASE)
      windowOf(w).released_.push_back({key, scancode, modifiers});
    else
      ImGui_ImplGlfw_KeyCallback(w, key, scancode, action, modifiers);
    if (action == GLFW_PRESS) windowOf(w).onKey(key, scancode, modifiers);
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int character) {
    ImGui_ImplGlfw_CharCallback(w, character);
    windowOf(w).active_ = true;
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    ImGui_ImplGlfw_WindowFocusCallback(w, focused);
    windowOf(w).active_ = true;
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    ImGui_ImplGlfw_CursorEnterCallback(w, entered);
    windowOf(w).active_ = true;
  });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { windowOf(w).active_ = true; });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    windowOf(w).active_ = true;
    WindowListener* const to = windowOf(w).listener_;
    if (to != nullptr && count > 0) to->open(paths[0]);
  });
}

Vec2 Window::shareOf(Vec2 position) const {
  const auto [width, height] = size();
  return position / Vec2(width, height);
}

void Window::onCursor(Vec2 position) {
  // A drag shows in the picture that it leads to, and nowhere else.
  if (drag_ == Drag::none) active_ = true;
  // Not glfwGetCursorPos(), which is ahead of the events.
  const Vec2 move = position - cursor_.value_or(position);
  cursor_ = position;
  if (listener_ == nullptr || move == Vec2(0) || drag_ == Drag::none) return;
  dragged_ += std::abs(move.x) + std::abs(move.y);
  const Vec2 drag = move / static_cast<float>(size()[1]);
  if (drag_ == Drag::orbit) listener_->orbit(drag);
  if (drag_ == Drag::pan) listener_->pan(drag);
  if (drag_ == Drag::light) listener_->turnLight(drag);
}

void Window::onButton(int button, bool pressed, int modifiers) {
  active_ = true;
  if (listener_ == nullptr) return;
  if (!cursor_) {
    double x = 0, y = 0;
    glfwGetCursorPos(window_.get(), &x, &y);
    cursor_ = Vec2(x, y);
  }
  const Vec2 at = shareOf(*cursor_);
  if (pressed) {
    if (drag_ != Drag::none || listener_->covered(at)) return;
    const bool left = button == GLFW_MOUSE_BUTTON_LEFT;
    const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    const bool control = (modifiers & GLFW_MOD_CONTROL) != 0;
    drag_ = !left || control ? Drag::pan : shift ? Drag::light : Drag::orbit;
    drag_button_ = button;
    dragged_ = 0;
    return;
  }
  if (drag_ == Drag::none || button != drag_button_) return;
  const bool clicked = drag_ == Drag::orbit && dragged_ <= kMostOfClick;
  drag_ = Drag::none;
  if (!clicked) return;
  const bool again = since_click_ && since_click_->seconds() < kDoubleClickSeconds;
  if (again) {
    since_click_.reset();
    listener_->doubleClick(at);
  } else {
    since_click_.emplace();
    listener_->click(at);
  }
}

void Window::onWheel(float steps) {
  active_ = true;
  if (listener_ == nullptr || !cursor_) return;
  const Vec2 at = shareOf(*cursor_);
  if (!listener_->covered(at)) listener_->zoom(steps, at);
}

void Window::onKey(int key, int scancode, int modifiers) {
  if (listener_ == nullptr) return;
  // The letter on the key, wherever the user's layout has it.
  const char* const name = glfwGetKeyName(key, scancode);
  std::optional<KeyPress> press = keyNamed(key, name != nullptr ? name : "");
  if (!press) return;
  press->control = (modifiers & GLFW_MOD_CONTROL) != 0;
  press->shift = (modifiers & GLFW_MOD_SHIFT) != 0;
  listener_->press(*press);
}

gl::ProcLoader Window::loader() const {
  return [](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); };
}

void Window::show() {
  glfwShowWindow(window_.get());
}

void Window::hide() {
  glfwHideWindow(window_.get());
}

void Window::setTitle(const std::string& title) {
  glfwSetWindowTitle(window_.get(), title.c_str());
}

void Window::swapBuffers() {
  glfwSwapBuffers(window_.get());
}

std::array<int, 2> Window::size() const {
  int width = 0, height = 0;
  glfwGetWindowSize(window_.get(), &width, &height);
  return {std::max(width, 1), std::max(height, 1)};
}

std::array<int, 2> Window::framebufferSize() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_.get(), &width, &height);
  return {std::max(width, 1), std::max(height, 1)};
}

float Window::scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_.get(), &x, &y);
  return std::max({x, y, 1.0f});
}

bool Window::minimized() const {
  return glfwGetWindowAttrib(window_.get(), GLFW_ICONIFIED) == GLFW_TRUE;
}

bool Window::closing() const {
  return glfwWindowShouldClose(window_.get()) == GLFW_TRUE;
}

void Window::close() {
  glfwSetWindowShouldClose(window_.get(), GLFW_TRUE);
}

// ImGui looks at keys once a frame: one that came up in the frame it went down was never down.
void Window::releaseKeys() {
  for (const auto& [key, scancode, modifiers] : std::exchange(released_, {}))
    ImGui_ImplGlfw_KeyCallback(window_.get(), key, scancode, GLFW_RELEASE, modifiers);
}

void Window::pollEvents() {
  releaseKeys();
  glfwPollEvents();
}

void Window::waitEvents(double most_seconds) {
  releaseKeys();
  glfwWaitEventsTimeout(most_seconds);
}

void Window::wake() {
  glfwPostEmptyEvent();
}

bool Window::takeActivity() {
  return std::exchange(active_, false);
}

}  // namespace glimt
