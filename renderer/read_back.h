// What a tracer has on the device, as pictures in memory: rows from the top.
#pragma once

#include "renderer/passes/path_tracer.h"
#include "renderer/passes/rest.h"
#include "renderer/renderer.h"

namespace glimt {

// The complete samples. Errors: as Target::readFloats, in all of these.
Picture readPicture(const PathTracer& tracer, const Rest& rest);

// Of the last sample, without the pixels at rest.
Losses readLosses(const PathTracer& tracer, const Rest& rest);

// The means over so many camera rays. To be called at a sample's start.
FirstHits readFirstHits(PathTracer& tracer, int rays);

// The picture with the colours of what the denoiser made of it.
Image readDenoised(Image picture, const gl::Target& denoised);

DisplayImage readDisplay(const gl::Target& target);

}  // namespace glimt
