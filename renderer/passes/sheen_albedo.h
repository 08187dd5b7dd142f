// What white fibres reflect in all: see shaders/sheen.glsl.
#pragma once

namespace glimt {

// Their directional albedo. `cosine` in (0, 1] is that of the direction with the normal,
// `roughness` in [0, 1].
double sheenAlbedoOf(double cosine, double roughness);

}  // namespace glimt
