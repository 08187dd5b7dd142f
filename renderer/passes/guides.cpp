#include "renderer/passes/guides.h"

#include "renderer/gl/errors.h"
#include "renderer/shader/composer.h"

namespace glimt {

// The targets are of the picture's size, and clear.
void Guides::prepare(const Film& film) {
  if (!sum_)
    sum_.emplace(device_->gl(), nameOf(Pass::guide_sum), composeVertexShader(),
                 composeFragmentShader(Pass::guide_sum));
  const int width = film.width();
  const int height = film.height();
  for (std::size_t i = 0; i < kGuides; ++i) {
    if (path_[i].width() != width || path_[i].height() != height) {
      path_[i] =
          gl::Target(gl::Texture::floats(device_->gl(), device_->floatForm(), width, height));
      sums_[i] = TargetPair(*device_, width, height);
    }
    sums_[i].clear();
  }
}

void Guides::extend(PathTracer& tracer, int rays, const WorkProgress& progress) {
  if (rays_ == 0) prepare(tracer.film());
  for (const int before = rays_; rays_ < rays; ++rays_) {
    if (progress) progress(static_cast<float>(rays_ - before) / static_cast<float>(rays - before));
    for (const gl::Target& path : path_) path.clear();
    tracer.drawGuides(rays_, {&path_[0], &path_[1]});
    add();
  }
}

void Guides::add() {
  gl::clearErrors(device_->gl());
  sum_->use();
  sum_->set("uZero", Vec4(0));
  sum_->set("uPictureStep", 1.0f / Vec2(path_[0].width(), path_[0].height()));
  for (std::size_t i = 0; i < kGuides; ++i) {
    sum_->set("uGuide", path_[i].texture());
    sum_->set("uGuideSum", sums_[i].front().texture());
    sums_[i].back().bind();
    device_->draw({0, 0, path_[i].width(), path_[i].height()});
    sums_[i].swap();
  }
  gl::checkErrors(device_->gl(), "drawing the pass " + nameOf(Pass::guide_sum));
}

void Guides::bind(gl::Program& program) const {
  program.set("uLooks", sums_[0].front().texture());
  program.set("uPlaces", sums_[1].front().texture());
  program.set("uGuideRays", static_cast<float>(rays_));
}

}  // namespace glimt
