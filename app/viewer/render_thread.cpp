#include "app/viewer/render_thread.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include "renderer/core/error.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr double kFrameSeconds = 1.0 / 30;

// Between two looks at what is asked for.
constexpr double kSliceSeconds = 0.01;

constexpr double kStatusSeconds = 0.2;

std::string describe(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "out of memory" : error.what();
}

}  // namespace

RenderThread::RenderThread(const RenderSettings& settings, MakeContext make_context,
                           std::function<void()> wake)
    : make_context_(std::move(make_context)), wake_(std::move(wake)) {
  std::promise<ContextInfo> ready;
  std::future<ContextInfo> info = ready.get_future();
  thread_ = std::thread([this, settings, &ready] { run(settings, ready); });
  try {
    info_ = info.get();
  } catch (...) {
    thread_.join();
    throw;
  }
}

RenderThread::~RenderThread() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  asked_.notify_one();
  thread_.join();
}

void RenderThread::ask(PictureRequest request) {
  {
    const std::lock_guard lock(mutex_);
    request_ = std::make_shared<const PictureRequest>(std::move(request));
    fresh_ = true;
  }
  asked_.notify_one();
}

void RenderThread::save(const std::filesystem::path& file) {
  {
    const std::lock_guard lock(mutex_);
    save_ = file;
  }
  asked_.notify_one();
}

std::optional<PictureFrame> RenderThread::takeFrame() {
  const std::lock_guard lock(mutex_);
  return std::exchange(frame_, std::nullopt);
}

std::vector<Message> RenderThread::takeMessages() {
  const std::lock_guard lock(mutex_);
  return std::exchange(messages_, {});
}

PictureStatus RenderThread::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void RenderThread::tell(Message message) {
  {
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
  }
  wake_();
}

void RenderThread::run(const RenderSettings& settings, std::promise<ContextInfo>& ready) {
  std::optional<ContextHandle> context;
  try {
    context.emplace(make_context_());
    ready.set_value(context->info());  // from here on `ready` may be gone
  } catch (...) {
    ready.set_exception(std::current_exception());
    return;
  }
  do {
    try {
      if (!context) context.emplace(make_context_());
      WindowPicture picture(*context, settings);
      WindowPicture beside(*context, settings);
      return serve(picture, beside);
    } catch (const std::exception& error) {
      fail(error);
    }
    context.reset();
  } while (waitForRequest());
}

// The window keeps the last picture until something else is asked for.
void RenderThread::fail(const std::exception& error) {
  {
    const std::lock_guard lock(mutex_);
    save_.reset();
  }
  tell({describe(error), true});
}

// Until the end.
void RenderThread::serve(WindowPicture& picture, WindowPicture& beside) {
  bool idle = false;
  while (const SharedRequest request = nextRequest(idle)) {
    turn(*request, picture, beside);
    idle = request->rest || (picture.finished() && beside.finished() && !picture.hasNews());
  }
}

// False at the end.
bool RenderThread::waitForRequest() {
  std::unique_lock lock(mutex_);
  asked_.wait(lock, [&] { return ending_ || fresh_ || save_.has_value(); });
  return !ending_;
}

// The latest one. Waits for another where there is nothing left to do. Null at the end.
RenderThread::SharedRequest RenderThread::nextRequest(bool idle) {
  if (idle) waitForRequest();
  const std::lock_guard lock(mutex_);
  fresh_ = false;
  return ending_ ? nullptr : request_;
}

void RenderThread::turn(const PictureRequest& request, WindowPicture& picture,
                        WindowPicture& beside) {
  if (request.rest) return;
  picture.ask(request.view, request.camera, request.size, request.serial);
  beside.ask(request.beside.value_or(View()), request.camera, request.size, request.serial);
  // The two take turns.
  const bool other = request.beside && beside_next_ && !beside.finished();
  (other ? beside : picture).work(kSliceSeconds);
  if (!request.beside) beside.work(0);  // lets go of what was compared
  beside_next_ = !beside_next_;
  publish(request, picture, beside);
  saveAsked(request, picture);
}

void RenderThread::publish(const PictureRequest& request, WindowPicture& picture,
                           WindowPicture& beside) {
  const bool news = picture.hasNews() || beside.hasNews();
  const bool complete = picture.samples() > 0 && (!request.beside || beside.samples() > 0);
  const bool due = picture.isFirst() || since_frame_.seconds() >= kFrameSeconds;
  bool told = false;
  if (news && complete && due) {
    PictureFrame frame{
        picture.frame(), picture.size(), request.beside ? beside.frame() : DisplayImage(),
        std::min(picture.serial(), request.beside ? beside.serial() : request.serial),
        picture.full()};
    const std::lock_guard lock(mutex_);
    frame_ = std::move(frame);
    since_frame_ = {};
    told = true;
  }
  if (told || since_status_.seconds() >= kStatusSeconds) {
    PictureStatus status = picture.status();
    const std::lock_guard lock(mutex_);
    status_ = std::move(status);
    since_status_ = {};
    told = true;
  }
  if (told) wake_();
}

void RenderThread::saveAsked(const PictureRequest& request, WindowPicture& picture) {
  std::optional<std::filesystem::path> file;
  {
    const std::lock_guard lock(mutex_);
    // What is to be saved may be of a request that this turn does not know yet.
    if (picture.full() && !fresh_) file = std::exchange(save_, std::nullopt);
  }
  if (!file) return;
  try {
    const Look& look = request.view.look;
    if (imageFormatOf(*file) == ImageFormat::png)
      writeDisplayImage(*file, picture.renderer().display(look.exposure, look.tone));
    else
      writeImage(*file, picture.renderer().radiance());
    tell(
        {fmt::format("saved {}, {}", file->string(), counted(picture.samples(), "sample")), false});
  } catch (const Error& error) {
    tell({error.what(), true});
  }
}

}  // namespace glimt
