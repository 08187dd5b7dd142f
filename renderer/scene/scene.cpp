#include "renderer/scene/scene.h"

#include <algorithm>

namespace glimt {

bool Environment::shines() const {
  const auto positive = [](const Vec3& v) { return v.x > 0 || v.y > 0 || v.z > 0; };
  return positive(radiance()) &&
         (image.pixels.empty() || std::any_of(image.pixels.begin(), image.pixels.end(), positive));
}

}  // namespace glimt
