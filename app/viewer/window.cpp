#include "app/viewer/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

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

void Window::installCallbacks() {
  GLFWwindow* const window = window_.get();
  glfwSetWindowUserPointer(window, this);
  glfwSetCursorPosCallback(
      window, [](GLFWwindow* w, double x, double y) { windowOf(w).onCursor(Vec2(x, y)); });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double steps) {
    if (WindowListener* const to = windowOf(w).listener_) to->zoom(static_cast<float>(steps));
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int) {
    if (action == GLFW_PRESS) windowOf(w).onKey(key, scancode);
  });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) {
    if (WindowListener* const to = windowOf(w).listener_) to->redraw();
  });
}

void Window::onCursor(Vec2 position) {
  int width = 0, height = 0;
  glfwGetWindowSize(window_.get(), &width, &height);
  // Not glfwGetCursorPos(), which is ahead of the events.
  const Vec2 drag =
      (position - last_cursor_.value_or(position)) / static_cast<float>(std::max(height, 1));
  last_cursor_ = position;
  if (listener_ == nullptr || drag == Vec2(0)) return;

  const auto button = [&](int which) {
    return glfwGetMouseButton(window_.get(), which) == GLFW_PRESS;
  };
  const auto key = [&](int which) { return glfwGetKey(window_.get(), which) == GLFW_PRESS; };
  const bool left = button(GLFW_MOUSE_BUTTON_LEFT);
  const bool shift = key(GLFW_KEY_LEFT_SHIFT) || key(GLFW_KEY_RIGHT_SHIFT);
  if (button(GLFW_MOUSE_BUTTON_RIGHT) || (left && shift)) {
    listener_->pan(drag);
  } else if (left) {
    listener_->orbit(drag);
  }
}

void Window::onKey(int key, int scancode) {
  if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window_.get(), GLFW_TRUE);
  if (listener_ == nullptr) return;
  // The letter on the key, wherever the user's layout has it.
  const char* const name = glfwGetKeyName(key, scancode);
  const std::string_view letter = name != nullptr ? name : "";
  if (letter == "r") listener_->reset();
  if (letter == "s") listener_->save();
}

ProcLoader Window::loader() const {
  return [](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); };
}

void Window::show() {
  glfwShowWindow(window_.get());
}

void Window::setTitle(const std::string& title) {
  glfwSetWindowTitle(window_.get(), title.c_str());
}

void Window::swapBuffers() {
  glfwSwapBuffers(window_.get());
}

std::array<int, 2> Window::framebufferSize() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_.get(), &width, &height);
  return {std::max(width, 1), std::max(height, 1)};
}

bool Window::minimized() const {
  return glfwGetWindowAttrib(window_.get(), GLFW_ICONIFIED) == GLFW_TRUE;
}

bool Window::closing() const {
  return glfwWindowShouldClose(window_.get()) == GLFW_TRUE;
}

void Window::pollEvents() {
  glfwPollEvents();
}

void Window::waitEvents() {
  glfwWaitEvents();
}

void Window::waitEvents(double most_seconds) {
  glfwWaitEventsTimeout(most_seconds);
}

}  // namespace glimt
