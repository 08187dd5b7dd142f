// A square that fills the picture, for what is looked up on it.
#pragma once

#include "tests/image/scenes.h"

namespace glimt::test {

// From (-1, -1, 0) to (1, 1, 0), facing the camera, the whole of its texture coordinates on it: (0,
// 0) in its upper left corner. The camera sees it and nothing else. Returns its material's index.
std::uint32_t addPicture(Scene& scene, const Material& material);

// The same with another depth, for a second one behind it; it is as large as the picture there.
std::uint32_t addPictureAt(Scene& scene, const Material& material, float z);

// Adds a picture, and returns a use of it without filtering.
TextureUse addImage(Scene& scene, int width, int height, const std::vector<std::uint8_t>& rgba);

// Shows its base colour.
Material unlit();

// Linear.
double linearOf(std::uint8_t srgb);

}  // namespace glimt::test
