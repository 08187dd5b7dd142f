// Dear ImGui in the window: its fonts, its style, its frames.
#pragma once

#include <imgui.h>

#include <memory>
#include <optional>

#include "app/viewer/gui_renderer.h"
#include "app/viewer/window.h"
#include "renderer/gl/context.h"

namespace glimt {

class Gui {
 public:
  // The window outlives this. Errors: no_gl, where the context lacks a function; failed.
  explicit Gui(Window& window);
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;
  ~Gui();

  // Between the two, ImGui may be called.
  void beginFrame();
  void endFrame();  // draws, and shows it

  GuiTexture makeTexture() const { return GuiTexture(context_->functions()); }

  bool wantsKeys() const;  // somebody types

 private:
  // ImGui's own state, and its view of the window.
  class Library {
   public:
    explicit Library(Window& window);
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    ~Library();
  };

  Window& window_;
  std::unique_ptr<gl::Context> context_;
  Library library_;
  std::optional<GuiRenderer> renderer_;
};

}  // namespace glimt
