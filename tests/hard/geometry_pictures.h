// Pictures of the hard cases of geometry, and figures for how far they are from each other.
#pragma once

#include "renderer/core/image.h"
#include "renderer/scene/scene.h"

namespace glimt::test {

// On the driver under test. Checks that no sample was lost.
Image hardPicture(const Scene& scene, int size, int bounces, int samples);
Image hardPicture(const Scene& scene, int width, int height, int bounces, int samples);

double brightnessOf(const Image& image);  // the mean over pixels and channels

// Of the pictures' means, relative to the second's.
double meanDifference(const Image& image, const Image& expected);

// The same between the mean of any block of `side` pixels squared and that of the picture expected;
// relative to the mean of the whole picture expected.
double worstBlockDifference(const Image& image, const Image& expected, int side);

// To the last bit.
int pixelsThatDiffer(const Image& a, const Image& b);

// Pixels in which any channel is not as given, to within `tolerance` of it.
int pixelsOtherThan(const Image& image, const Vec3& expected, double tolerance = 0);

}  // namespace glimt::test
