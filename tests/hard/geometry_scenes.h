// Scenes of the hard cases of geometry.
#pragma once

#include "renderer/scene/scene.h"
#include "tests/image/scenes.h"

namespace glimt::test {

// A room of 2 m around the origin, open towards the camera: white but for a red and a green wall,
// with a light under the ceiling and two blocks, one of them turned.
Scene cornellBox();

// A room that is closed: its walls emit nothing and are white, and everything outside shines. What
// is seen of the light has come through the walls.
Scene shiningOutside(Scene scene);

// The scene, camera included, scaled about the origin and then moved.
Scene transformed(Scene scene, float scale, const Vec3& offset);

// A box with its front sides outside; its edges are along the axes.
void addBlock(Scene& scene, const Vec3& low, const Vec3& high, std::uint32_t material);

// A quad as addQuad makes it, cut across edge2 into that many strips of two triangles each. Strips
// share their vertices' coordinates, to the last bit.
void addStrips(Scene& scene, const Vec3& corner, const Vec3& edge1, const Vec3& edge2, int strips,
               std::uint32_t material);

}  // namespace glimt::test
