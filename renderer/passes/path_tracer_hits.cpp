// What a path tracer tells of the surfaces that paths meet, beside the light that they bring.
#include "renderer/gl/errors.h"
#include "renderer/passes/camera_uniforms.h"
#include "renderer/passes/path_tracer.h"

namespace glimt {

// Leaves what the camera's rays met in the front record.
void PathTracer::drawFirstRays(std::uint32_t sample) {
  gl::Program& rays = program(Pass::camera);
  bindPath(rays, {Pass::camera, 0}, sample);
  bindCamera(rays, camera_, film_.width(), film_.height());
  film_.record.back().bind();
  device_->draw(whole());
  film_.record.swap();
}

std::vector<Vec4> PathTracer::firstHits(int sample, int wanted) {
  if (!programs_.contains(keyOf(Pass::first_hit))) compilePass(Pass::first_hit);
  gl::clearErrors(device_->gl());
  const std::uint32_t drawn = first_sample_ + static_cast<std::uint32_t>(sample);
  drawFirstRays(drawn);
  const gl::Target told(
      gl::Texture::floats(device_->gl(), device_->floatForm(), film_.width(), film_.height()));
  gl::Program& hits = program(Pass::first_hit);
  bindPath(hits, {Pass::camera, 0}, drawn);
  hits.set("uWanted", static_cast<float>(wanted));
  told.bind();
  device_->draw(whole());
  gl::checkErrors(device_->gl(), "drawing the pass " + nameOf(Pass::first_hit));
  return told.readFloats();
}

// Leaves in the front record what mirrors and glass in it show. False where there are none.
bool PathTracer::drawDeltaRays(const Stage& stage, std::uint32_t sample) {
  gl::Program& rays = program(Pass::delta);
  bindPath(rays, stage, sample);
  rays.set("uFromCamera", stage.bounce == 1 ? 1.0f : 0.0f);
  film_.record.back().clear();
  film_.record.back().bind();
  query_.begin();
  device_->draw(whole());
  query_.end();
  film_.record.swap();
  return query_.anyPassed();
}

void PathTracer::drawGuides(int sample, const std::array<const gl::Target*, kGuides>& targets) {
  const bool follows = has(effects_, Effect::mirror) || has(effects_, Effect::glass);
  if (!programs_.contains(keyOf(Pass::guide))) compilePass(Pass::guide);
  if (follows && !programs_.contains(keyOf(Pass::delta))) compilePass(Pass::delta);
  gl::clearErrors(device_->gl());
  const std::uint32_t drawn = first_sample_ + static_cast<std::uint32_t>(sample);
  const auto tell = [&](int bounce) {
    gl::Program& guide = program(Pass::guide);
    bindPath(guide, {Pass::trace, bounce}, drawn);
    bindCamera(guide, camera_, film_.width(), film_.height());
    guide.set("uFromCamera", bounce == 0 ? 1.0f : 0.0f);
    for (std::size_t wanted = 0; wanted < targets.size(); ++wanted) {
      guide.set("uWanted", static_cast<float>(wanted));
      targets[wanted]->bind();
      device_->draw(whole());
    }
  };
  drawFirstRays(drawn);
  tell(0);
  for (int bounce = 1; follows && bounce <= bounces_ + 1; ++bounce) {
    if (!drawDeltaRays({Pass::trace, bounce}, drawn)) break;
    tell(bounce);
  }
  gl::checkErrors(device_->gl(), "drawing the pass " + nameOf(Pass::guide));
}

}  // namespace glimt
