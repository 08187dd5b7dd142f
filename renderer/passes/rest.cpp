#include "renderer/passes/rest.h"

#include <algorithm>
#include <cmath>

#include "shaders/layout.h"

namespace glimt {
namespace {

// A square never has less than this share of the samples of the one that has most: what a few
// samples do not show of it, more may.
constexpr double kLeastShare = 0.125;

// Of a pixel whose path meets nothing, in what a triangle on it takes.
constexpr double kLeastWork = 0.3;

int squares(int pixels) {
  return (pixels + CHANGE_SQUARE - 1) / CHANGE_SQUARE;
}

// The sum over the squares that are not at rest, when each has its due of `most` samples.
double noiseWith(double most, const std::vector<double>& noise, const std::vector<double>& due,
                 double samples, double power) {
  double sum = 0;
  for (std::size_t i = 0; i < noise.size(); ++i)
    sum += noise[i] * std::pow(std::max(most * due[i] / samples, 1.0), -power);
  return sum;
}

}  // namespace

Rest::Rest(int width, int height)
    : width_(width),
      height_(height),
      columns_(squares(width)),
      rows_(squares(height)),
      samples_(static_cast<std::size_t>(columns_) * rows_, 0) {}

int Rest::samplesAt(int x, int y) const {
  return samples_[static_cast<std::size_t>(y / CHANGE_SQUARE) * columns_ + x / CHANGE_SQUARE];
}

// The largest mean of three by three squares that one is part of: what a square shows by itself is
// known too badly, and one that seems calm beside a noisy one may not be.
std::vector<double> Rest::smoothed(const std::vector<double>& noise) const {
  const auto around = [&](const std::vector<double>& values, const auto& join) {
    std::vector<double> out;
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        double joined = 0;
        for (int j = std::max(row - 1, 0); j <= std::min(row + 1, rows_ - 1); ++j)
          for (int i = std::max(column - 1, 0); i <= std::min(column + 1, columns_ - 1); ++i)
            joined = join(joined, values[static_cast<std::size_t>(j) * columns_ + i]);
        out.push_back(joined);
      }
    return out;
  };
  return around(around(noise, [](double a, double b) { return a + b / 9; }),
                [](double a, double b) { return std::max(a, b); });
}

std::vector<double> Rest::workOf(const std::vector<float>& lengths) const {
  std::vector<double> work(samples_.size(), 0);
  if (lengths.size() != static_cast<std::size_t>(width_) * height_)  // of a picture of another size
    return std::vector<double>(samples_.size(), 1);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const std::size_t x = i % static_cast<std::size_t>(width_);
    const std::size_t y = i / static_cast<std::size_t>(width_);
    work[y / CHANGE_SQUARE * static_cast<std::size_t>(columns_) + x / CHANGE_SQUARE] +=
        kLeastWork + lengths[i];
  }
  return work;
}

bool Rest::decide(const std::vector<double>& noise, const std::vector<float>& lengths, int samples,
                  double power, double goal) {
  std::vector<double> active = noise;
  for (std::size_t i = 0; i < active.size(); ++i)
    if (samples_[i] > 0) active[i] = 0;
  const std::vector<double> work = workOf(lengths);
  std::vector<double> due = smoothed(active);
  for (std::size_t i = 0; i < due.size(); ++i) due[i] = std::pow(due[i] / work[i], 1 / (1 + power));
  const double largest = *std::max_element(due.begin(), due.end());
  if (!(largest > 0)) return false;
  for (double& value : due) value = std::max(value / largest, kLeastShare);

  double most = samples;
  const double left = goal - noise_;
  if (!(left > 0)) return false;
  while (noiseWith(most, active, due, samples, power) > left) most *= 1.02;
  // The goal is met, so all would.
  if (!(most > samples)) return false;
  bool more = false;
  for (std::size_t i = 0; i < due.size(); ++i) {
    if (samples_[i] > 0 || most * due[i] > samples) continue;
    samples_[i] = samples;
    noise_ += noise[i];
    more = true;
  }
  return more;
}

gl::Tile Rest::tileOf(int column, int row, int columns) const {
  const int x = column * CHANGE_SQUARE;
  const int y = row * CHANGE_SQUARE;
  return {x, y, std::min(columns * CHANGE_SQUARE, width_ - x),
          std::min(CHANGE_SQUARE, height_ - y)};
}

double Rest::meanSamples(int samples) const {
  double sum = 0;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const gl::Tile tile = tileOf(column, row, 1);
      const int own = samples_[static_cast<std::size_t>(row) * columns_ + column];
      sum += static_cast<double>(tile.width) * tile.height * (own > 0 ? own : samples);
    }
  return sum / (static_cast<double>(width_) * height_);
}

std::vector<gl::Tile> Rest::tiles() const {
  std::vector<gl::Tile> tiles;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_;) {
      const auto rests = [&](int at) {
        return at < columns_ && samples_[static_cast<std::size_t>(row) * columns_ + at] > 0;
      };
      int end = column;
      while (rests(end)) ++end;
      if (end > column) tiles.push_back(tileOf(column, row, end - column));
      column = end + 1;
    }
  return tiles;
}

}  // namespace glimt
