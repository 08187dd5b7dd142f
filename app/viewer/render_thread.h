// The renderer on a thread and in a context of its own, so that no pass and no compiler of shaders
// keeps the window waiting.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/viewer/window_picture.h"

namespace glimt {

// What the window shows. The last request is the one that counts.
struct PictureRequest {
  View view;
  std::optional<View> beside;  // to compare with
  Camera camera;
  std::array<int, 2> size{1, 1};  // in pixels
  bool rest = false;              // nobody looks
  std::uint64_t serial = 0;       // of the request, to tell which one a frame answers
};

struct PictureFrame {
  DisplayImage image;
  std::array<int, 2> size{1, 1};  // that was asked for; the image is smaller while it is a preview
  DisplayImage beside;            // empty where nothing is compared
  std::uint64_t serial = 0;       // of the latest request that it answers
  bool full = false;              // not a preview
};

// A line for people. A failure is one that they have to know of.
struct Message {
  std::string text;
  bool failure = false;
};

class RenderThread {
 public:
  // Makes a context that is current on the thread it is called on.
  using MakeContext = std::function<ContextHandle()>;

  // Ready when it comes back. `make_context` is called on the thread, at first and again after a
  // failure, since the context may be lost. `wake` is called on the thread when there is something
  // to take. Errors: those of the first context.
  RenderThread(const RenderSettings& settings, MakeContext make_context,
               std::function<void()> wake);
  RenderThread(const RenderThread&) = delete;
  RenderThread& operator=(const RenderThread&) = delete;
  ~RenderThread();

  void ask(PictureRequest request);

  // Writes the picture as it is, as soon as it is one in full size; a message says so.
  void save(const std::filesystem::path& file);

  std::optional<PictureFrame> takeFrame();
  std::vector<Message> takeMessages();
  PictureStatus status() const;
  const ContextInfo& context() const { return info_; }

 private:
  using SharedRequest = std::shared_ptr<const PictureRequest>;

  void run(const RenderSettings& settings, std::promise<ContextInfo>& ready);
  void fail(const std::exception& error);
  bool waitForRequest();
  void serve(WindowPicture& picture, WindowPicture& beside);
  void turn(const PictureRequest& request, WindowPicture& picture, WindowPicture& beside);
  void publish(const PictureRequest& request, WindowPicture& picture, WindowPicture& beside);
  void saveAsked(const PictureRequest& request, WindowPicture& picture);
  void tell(Message message);
  SharedRequest nextRequest(bool idle);

  MakeContext make_context_;
  std::function<void()> wake_;
  ContextInfo info_;
  Stopwatch since_frame_;     // the thread's own
  Stopwatch since_status_;    // the thread's own
  bool beside_next_ = false;  // the thread's own

  mutable std::mutex mutex_;  // of all that follows
  std::condition_variable asked_;
  SharedRequest request_ = std::make_shared<PictureRequest>();
  bool fresh_ = false;  // nobody has looked at the request yet
  std::optional<std::filesystem::path> save_;
  std::optional<PictureFrame> frame_;
  std::vector<Message> messages_;
  PictureStatus status_;
  bool ending_ = false;

  std::thread thread_;  // last, so that it ends before what it uses
};

}  // namespace glimt
