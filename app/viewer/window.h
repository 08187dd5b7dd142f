// A window with an OpenGL ES 2.0 context, and what the user does in it.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/stopwatch.h"
#include "renderer/core/vector.h"
#include "renderer/gl/functions.h"

struct GLFWwindow;

namespace glimt {

enum class Key {
  escape,
  tab,
  f1,
  space,
  // letters, wherever the user's layout has them
  c,
  d,
  f,
  o,
  r,
  s,
  t,
  y,
  z,
  digit,
};

struct KeyPress {
  Key key = Key::escape;
  int digit = 0;  // of Key::digit
  bool control = false;
  bool shift = false;
};

// Drags are in window heights, to the right and downwards; places are shares of the window's width
// and height, from the top left.
class WindowListener {
 public:
  virtual void orbit(Vec2 drag) noexcept = 0;
  virtual void pan(Vec2 drag) noexcept = 0;
  virtual void turnLight(Vec2 drag) noexcept = 0;
  virtual void zoom(float steps, Vec2 at) noexcept = 0;  // positive is closer
  virtual void click(Vec2 at) noexcept = 0;
  virtual void doubleClick(Vec2 at) noexcept = 0;
  virtual void press(const KeyPress& key) noexcept = 0;
  virtual void open(const std::filesystem::path& dropped) noexcept = 0;
  // Whether the mouse is on something that lies on the picture.
  virtual bool covered(Vec2 at) noexcept = 0;

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

  gl::ProcLoader loader() const;
  GLFWwindow* get() const { return window_.get(); }

  void show();
  void hide();
  void setTitle(const std::string& title);
  void swapBuffers();

  std::array<int, 2> size() const;             // in the units of places; both at least 1
  std::array<int, 2> framebufferSize() const;  // in pixels; both at least 1
  float scale() const;                         // of text: 1 on a usual display
  bool minimized() const;
  bool closing() const;
  void close();

  // The listener outlives the window's last event.
  void listen(WindowListener& listener) { listener_ = &listener; }
  void pollEvents();
  void waitEvents(double most_seconds);
  // Ends waitEvents(); on any thread.
  static void wake();

  // Whether there was any event since the last call, but for drags.
  bool takeActivity();

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
  enum class Drag { none, orbit, pan, light };

  void open(std::array<int, 2> size, const std::string& title);
  void installCallbacks();
  void onCursor(Vec2 position);
  void onButton(int button, bool pressed, int modifiers);
  void onWheel(float steps);
  void onKey(int key, int scancode, int modifiers);
  void releaseKeys();
  Vec2 shareOf(Vec2 position) const;

  Library library_;
  std::unique_ptr<GLFWwindow, Destroy> window_;
  WindowListener* listener_ = nullptr;
  std::optional<Vec2> cursor_;
  Drag drag_ = Drag::none;
  int drag_button_ = 0;
  float dragged_ = 0;                         // pixels since the button was pressed
  std::optional<Stopwatch> since_click_;      // the last that was none of a double click
  std::vector<std::array<int, 3>> released_;  // key, scancode, modifiers; ImGui is not told yet
  bool active_ = false;
};

}  // namespace glimt
