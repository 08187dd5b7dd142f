#include "app/batch/batch_renderer.h"

#include "renderer/core/error.h"
#include "renderer/scene/load_scene.h"

namespace glimt {

const Scene& BatchRenderer::sceneOf(const std::string& variant) {
  if (variant_ != variant) {
    variant_.reset();
    scene_ = loadScene(job_.scene,
                       {variant, job_.picture.environment, job_.picture.transparent_background});
    own_camera_ = scene_.camera;
    variant_ = variant;
  }
  scene_.camera = own_camera_;
  return scene_;
}

const Scene& BatchRenderer::sceneOf(const BatchPicture& picture) {
  sceneOf(picture.variant);
  CameraOptions camera = job_.picture.camera;
  if (!picture.camera.empty()) camera.name = picture.camera;
  scene_.camera = cameraOf(camera, scene_);
  if (picture.angle)
    scene_.camera = turned(scene_.camera, *picture.angle, job_.turntable->elevation);
  return scene_;
}

RenderSettings BatchRenderer::settingsOf(const BatchPicture& picture) {
  PictureOptions options = job_.picture;
  options.size = picture.size;
  RenderSettings settings = glimt::settingsOf(options, sceneOf(picture));
  settings.keep_spread = job_.denoise;
  return settings;
}

Sampling BatchRenderer::render(const BatchPicture& picture, const Interrupt& interrupt,
                               const WorkProgress& progress, const SamplingListener& listener) {
  prepare(picture, progress);
  Sampling sampling = sampleUntil(*renderer_, job_.limits, interrupt, listener);
  if (job_.denoise && sampling.ended_by != EndedBy::interrupt && sampling.failure.empty())
    sampling.picture.radiance = renderer_->denoised([&interrupt](float) {
      if (interrupt.requested()) throw Error(ErrorKind::failed, "interrupted");
    });
  return sampling;
}

void BatchRenderer::prepare(const BatchPicture& picture, const WorkProgress& progress) {
  const Scene& scene = sceneOf(picture);
  const RenderSettings settings = settingsOf(picture);
  if (!context_) context_ = createOffscreenContext(job_.backend, job_.picture.gles);
  if (renderer_ && drawn_variant_ != picture.variant) {
    try {
      renderer_->setMaterials(scene);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::usage) throw;
      renderer_.reset();  // the variant's triangles are others
    }
  }
  if (!renderer_) renderer_.emplace(*context_, scene, settings, progress);
  drawn_variant_ = picture.variant;
  renderer_->setLimits({settings.bounces, settings.clamp});
  renderer_->resize(settings.width, settings.height);
  renderer_->setCamera(scene.camera);
  if (!job_.even) renderer_->restBelow(job_.limits.noise);
}

void BatchRenderer::forget() {
  renderer_.reset();
  context_.reset();
}

}  // namespace glimt
