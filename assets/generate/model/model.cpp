#include "assets/generate/model/model.h"

namespace glimt::assets {

std::size_t triangleCount(const Model& model) {
  std::size_t count = 0;
  for (const Part& part : model.parts) count += part.mesh.triangles.size();
  return count;
}

}  // namespace glimt::assets
