// A share of the samples of a picture, and how shares become one.
#pragma once

#include <string>
#include <vector>

#include "renderer/core/image_layers.h"

namespace glimt {

// Samples from `first` on, so many.
struct SampleRange {
  int first = 0;
  int count = 0;

  int end() const { return first + count; }
};

struct Share {
  std::vector<SampleRange> ranges;  // in order, with a gap between any two
  std::string inputs;               // SHA-256 of what the picture depends on, but for the range
  Image mean;
  std::vector<float> samples;  // of each pixel: those that were lost are not in the mean
  std::vector<float> spread;   // standard deviation of the luminance of each pixel's samples
};

int samplesOf(const Share& share);

// As an EXR keeps it: the mean as colour, the channels `samples` and `spread`, and two notes.
ImageLayers layersOf(const Share& share);

// Errors: input, without the file's name, for a picture that is no share.
Share shareOf(const ImageLayers& layers);

// Joins shares of one picture. Computes in double: what comes out is rounded once.
class ShareSum {
 public:
  // Errors: input, without the file's name, where the share is not of the same picture as those
  // before, or has samples in common with them.
  void add(const Share& share);

  // Of at least one.
  Share share() const;

 private:
  struct Pixel {
    glm::dvec3 mean{0};
    double samples = 0;
    double spread = 0;
  };

  std::vector<SampleRange> ranges_;
  std::string inputs_;
  int width_ = 0;
  int height_ = 0;
  std::vector<Pixel> pixels_;
};

// The relative noise of the mean if its samples were independent, which those of a low-discrepancy
// sequence are not: the true one is hardly ever above it. As NoiseEstimate defines it.
double independentNoise(const Share& share);

}  // namespace glimt
