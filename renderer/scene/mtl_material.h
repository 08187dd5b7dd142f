// What a material of an MTL stands for, in glTF's terms: docs/materials.md has the table.
#pragma once

#include <tiny_obj_loader.h>

#include "renderer/scene/scene.h"

namespace glimt {

// Nothing but the surface: no name, no pictures. Ns, Ni, Tf, Pr and Pm are negative where the file
// does not give them. Values are not checked.
Material materialOfMtl(const tinyobj::material_t& m);

}  // namespace glimt
