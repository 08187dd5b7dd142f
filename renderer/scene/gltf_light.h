// The lights of a glTF scene: KHR_lights_punctual.
#pragma once

#include <string>
#include <vector>

#include "renderer/scene/gltf_node.h"
#include "renderer/scene/scene.h"

namespace glimt {

// One for each node that has a light. glTF gives candela and lux, and glimt takes the numbers for
// W/sr and W/m^2 as they stand: as it takes emissive factors, which are cd/m^2 there, for radiance.
// So lights and surfaces of a file keep their proportion, and only --exposure has to know.
// `origin` is the scene's. Errors: input, for kinds that do not exist.
std::vector<PunctualLight> lightsOf(const GltfDocument& document,
                                    const std::vector<GltfInstance>& instances,
                                    const glm::dvec3& origin, std::vector<std::string>& warnings);

}  // namespace glimt
