// The viewer's renderer where the driver fails: what the window is told, and what comes after.
#include "app/viewer/render_thread.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>

#include "tests/gpu/altered_context.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;

namespace {

// Functions of GL know nothing but their arguments.
bool compiles = true;

void shaderStatus(GLuint, GLenum name, GLint* value) {
  *value = name == GL_COMPILE_STATUS ? GL_FALSE : 64;
}

void shaderLog(GLuint, GLsizei size, GLsizei* written, GLchar* log) {
  const int length =
      std::snprintf(log, static_cast<std::size_t>(size), "0:1(1): error: too many registers");
  *written = std::min(length, size - 1);
}

// Whose drivers refuse shaders unless `compiles`. Those of them outlive the renderer.
class Contexts {
 public:
  ContextHandle make() {
    ContextHandle real = createOffscreenContext(Backend::egl, 2);
    if (compiles) return real;
    refusing_.push_back(std::move(real));
    return ContextHandle(test::alteredContext(refusing_.back().get(), [](gl::Functions& functions) {
      functions.GetShaderiv = shaderStatus;
      functions.GetShaderInfoLog = shaderLog;
    }));
  }

 private:
  std::vector<ContextHandle> refusing_;
};

// What the window's thread does when it is woken.
class Bell {
 public:
  void ring() {
    {
      const std::lock_guard lock(mutex_);
      rung_ = true;
    }
    waiting_.notify_one();
  }
  void wait() {
    std::unique_lock lock(mutex_);
    waiting_.wait(lock, [&] { return std::exchange(rung_, false); });
  }

 private:
  std::mutex mutex_;
  std::condition_variable waiting_;
  bool rung_ = false;
};

PictureRequest requestOf(std::uint64_t serial) {
  Scene scene = test::furnace(0.5f);
  const Look look = lookOf(scene, "", 1, 0, Tone::srgb);
  const Camera camera = scene.camera;
  Tree tree(scene);
  PictureRequest request;
  request.view = {std::make_shared<const LoadedScene>(
                      LoadedScene{{}, std::move(scene), std::move(tree), 0, {}}),
                  look};
  request.camera = camera;
  request.size = {8, 8};
  request.serial = serial;
  return request;
}

}  // namespace

TEST_CASE("a driver that refuses a shader is told of, and a later one gives the picture") {
  Contexts contexts;
  Bell bell;
  compiles = false;
  RenderThread renderer(
      {}, [&] { return contexts.make(); }, [&] { bell.ring(); });
  renderer.ask(requestOf(1));
  std::vector<Message> messages;
  while (messages.empty()) {
    bell.wait();
    messages = renderer.takeMessages();
  }
  REQUIRE(messages.size() == 1);
  CHECK(messages[0].failure);
  CHECK_THAT(messages[0].text, Catch::Contains("too many registers"));
  CHECK_FALSE(renderer.takeFrame());

  compiles = true;
  renderer.ask(requestOf(2));
  std::optional<PictureFrame> frame;
  while (!frame) {
    bell.wait();
    REQUIRE(renderer.takeMessages().empty());
    frame = renderer.takeFrame();
  }
  CHECK(frame->serial == 2);
}
