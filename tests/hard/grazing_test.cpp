// Light and eye that graze a plane, down to a ten-thousandth of a radian. Under a small distant
// light the irradiance falls with the sine of the elevation.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/hard/bsdfs.h"
#include "tests/hard/hard_case.h"
#include "tests/hard/hard_picture.h"
#include "tests/image/pictures.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr float kAlbedo = 0.8f;

// A plane of two metres a side, and a light `distance` away that rises `elevation` above it and is
// a fifth of that high.
Scene plane(const Bsdf& bsdf, float distance, float elevation) {
  Scene scene;
  addQuad(scene, Vec3(-1, 0, 1), Vec3(2, 0, 0), Vec3(0, 0, -2),
          add(scene, bsdf.material(kAlbedo, 0)));
  const float height = elevation * distance;
  const float half = 0.1f * height;
  // Of such a radiance that a surface that faces it has an irradiance of 1.
  const float radiance = distance * distance / (4 * half * half);
  addQuad(scene, Vec3(-half, height - half, -distance), Vec3(2 * half, 0, 0), Vec3(0, 2 * half, 0),
          add(scene, lambert("light", Vec3(0), Vec3(radiance))));
  return scene;
}

// In the middle of the plane.
double expectedRadiance(const Scene& scene) {
  std::vector<glm::dvec3> light;
  for (std::size_t i = 6; i < 12;
       ++i)  // of the two triangles of the light, the common corners once
    if (i != 9 && i != 10) light.emplace_back(scene.positions[i]);
  return kAlbedo / std::acos(-1.0) *
         polygonIrradiance(light, glm::dvec3(0), glm::dvec3(0, 1, 0),
                           scene.materials[1].emission.g);
}

double error(const Scene& scene) {
  const Image image = hardPicture(scene, settingsFor(16, 0), slowDriver() ? 64 : 128);
  return relativeError(meanRadiance(image), expectedRadiance(scene));
}

}  // namespace

TEST_CASE("light that grazes a plane lights it by the sine of its elevation") {
  for (const Bsdf& bsdf : kBsdfs)
    for (const float distance : {1.25f, 1000.0f})
      for (const float elevation : {1e-1f, 1e-2f, 1e-3f, 1e-4f}) {
        Scene scene = plane(bsdf, distance, elevation);
        lookAtSpot(scene, Vec3(0, 2, 0.01f), Vec3(0));
        scene.camera.up = Vec3(0, 0, -1);
        checkAtMost("shading",
                    fmt::format("light grazes a plane at {:g} rad from {:g} m, {}", elevation,
                                distance, bsdf.name),
                    "irradiance, relative error", error(scene), 0.005);
      }
}

TEST_CASE("an eye that grazes a plane sees what it sees from above") {
  for (const Bsdf& bsdf : kBsdfs)
    for (const float elevation : {1e-1f, 1e-2f, 1e-3f, 1e-4f}) {
      const float distance = 1000;  // so far that it lights all of the plane alike
      Scene scene = plane(bsdf, distance, 0.5f);
      scene.camera.position = Vec3(0.5f, 0.5f * elevation, 0);
      scene.camera.target = Vec3(0, 0, 0);
      scene.camera.vertical_fov = 20 * elevation;  // a third of the elevation
      checkAtMost("shading",
                  fmt::format("eye grazes a plane at {:g} rad, {}", elevation, bsdf.name),
                  "irradiance, relative error", error(scene), 0.005);
    }
}
