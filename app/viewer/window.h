// A window with an OpenGL ES 2.0 context, and what the user does in it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "renderer/core/vector.h"
#include "renderer/renderer.h"

struct GLFWwindow;

namespace glimt {

// Drags are in window heights, to the right and downwards.
class WindowListener {
 public:
  virtual void orbit(Vec2 drag) noexcept = 0;
  virtual void pan(Vec2 drag) noexcept = 0;
  virtual void zoom(float steps) noexcept = 0;  // positive is closer
  virtual void reset() noexcept = 0;
  virtual void save() noexcept = 0;
  virtual void redraw() noexcept = 0;  // the window has lost what it showed

 protected:
  ~WindowListener() = default;
};

class Window {
 public:
  // Hidden, and its context current on this thread. A size that the monitor has no room for is
  // reduced to one of the same shape. `scaled`: the size is one of a usual display, and larger on
  // one with finer pixels. Errors: no_gl.
  Window(std::array<int, 2> size, bool scaled, const std::string& title);
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window();

  ProcLoader loader() const;

  void show();
  void setTitle(const std::string& title);
  void swapBuffers();

  std::array<int, 2> framebufferSize() const;  // both at least 1
  bool minimized() const;
  bool closing() const;

  // The listener outlives the window's last event.
  void listen(WindowListener& listener) { listener_ = &listener; }
  void pollEvents();
  void waitEvents();
  void waitEvents(double most_seconds);

 private:
  // GLFW as a whole, from first to last.
  class Library {
   public:
    Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    ~Library();
  };
  struct Destroy {
    void operator()(GLFWwindow* window) const;
  };

  void open(std::array<int, 2> size, const std::string& title);
  void installCallbacks();
  void onCursor(Vec2 position);
  void onKey(int key, int scancode);

  Library library_;
  std::unique_ptr<GLFWwindow, Destroy> window_;
  WindowListener* listener_ = nullptr;
  std::optional<Vec2> last_cursor_;
};

}  // namespace glimt
