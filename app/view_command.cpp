#include <fmt/format.h>

#include "app/commands.h"
#include "app/message.h"
#include "app/progress.h"
#include "app/viewer/default_scene.h"
#include "app/viewer/viewer.h"
#include "app/viewer/window.h"
#include "renderer/core/error.h"
#include "renderer/scene/framing.h"
#include "renderer/scene/load_scene.h"

namespace glimt {
namespace {

Scene load(const ViewOptions& options) {
  Scene scene = loadScene(options.scene ? *options.scene : defaultScene(),
                          {options.load.variant, options.picture.environment});
  scene.camera = withTargetAtModel(cameraOf(options.picture.camera, scene), boundsOf(scene));
  if (scene.name.empty()) scene.name = "scene";
  return scene;
}

}  // namespace

int runView(const ViewOptions& options) {
  if (options.picture.gles != 2) {
    throw Error(ErrorKind::usage, "the window is drawn with OpenGL ES 2.0; leave out --gles");
  }
  Progress progress(true);
  progress.show("loading");
  const Scene scene = load(options);
  progress.clear();
  for (const std::string& warning : scene.warnings) say(fmt::format("warning: {}", warning));

  progress.show("building the tree");
  RenderSettings settings = settingsOf(options.picture, scene);
  const bool scaled = !options.picture.size.has_value();
  Window window({settings.width, settings.height}, scaled, scene.name);
  ContextHandle context = adoptCurrentContext(window.loader());
  settings.width = window.framebufferSize()[0];
  settings.height = window.framebufferSize()[1];
  Renderer renderer(context, scene, settings,
                    [&](float fraction) { showTree(progress, fraction); });
  progress.clear();

  const ViewerSettings viewer{scene.name, scene.camera, exposureOf(options.picture, scene),
                              toneOf(options.picture, scene)};
  Viewer(window, renderer, viewer).run();
  return 0;
}

}  // namespace glimt
