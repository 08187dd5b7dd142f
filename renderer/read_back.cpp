#include "renderer/read_back.h"

#include <algorithm>
#include <cmath>

#include "renderer/core/luminance.h"
#include "renderer/scene/camera.h"

namespace glimt {
namespace {

// Rows from the top, of those that GL has from the bottom.
template <typename Value, typename Sized, typename ValueOf>
std::vector<Value> fromTop(const std::vector<Vec4>& texels, const Sized& film,
                           const ValueOf& valueOf) {
  std::vector<Value> values;
  values.reserve(texels.size());
  for (int y = film.height() - 1; y >= 0; --y)
    for (int x = 0; x < film.width(); ++x)
      values.push_back(valueOf(texels[static_cast<std::size_t>(y) * film.width() + x]));
  return values;
}

// What covers a pixel: surfaces and, where there are none, the shadow on a catcher.
float alphaOf(const Vec4& seen) {
  const float shadow = seen.z > 0 ? 1 - seen.y / seen.z : 0;
  return std::clamp(seen.x + (1 - seen.x) * shadow, 0.0f, 1.0f);
}

// What is kept of the pixels beside the mean, whose texels these are.
void addKept(Picture& picture, const PathTracer& tracer, const std::vector<Vec4>& means) {
  const Film& film = tracer.film();
  picture.pixel_samples = fromTop<float>(means, film, [](const Vec4& mean) { return mean.a; });
  if (const Accumulation* const coverage = tracer.kept(Accumulated::coverage))
    picture.radiance.alpha = fromTop<float>(coverage->readMean(), film, alphaOf);
  if (const Accumulation* const lengths = tracer.kept(Accumulated::path_length))
    picture.path_lengths =
        fromTop<float>(lengths->readMean(), film, [](const Vec4& mean) { return mean.x; });
  const Accumulation* const squares = tracer.kept(Accumulated::square);
  if (squares == nullptr) return;
  picture.spread =
      fromTop<float>(squares->readMean(), film, [](const Vec4& mean) { return mean.x; });
  for (std::size_t i = 0; i < picture.spread.size(); ++i) {
    const double light = luminance(picture.radiance.pixels[i]);
    const double variance = picture.spread[i] - light * light;
    picture.spread[i] = static_cast<float>(std::sqrt(std::max(variance, 0.0)));
  }
}

}  // namespace

Picture readPicture(const PathTracer& tracer, const Rest& rest) {
  const Film& film = tracer.film();
  const std::vector<Vec4> texels = tracer.accumulation().readMean();
  Picture picture{{film.width(), film.height(), {}}, tracer.samples(), 0, 0};
  picture.mean_samples = rest.meanSamples(picture.samples);
  picture.radiance.pixels =
      fromTop<Vec3>(texels, film, [](const Vec4& mean) { return Vec3(mean); });
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const auto at = static_cast<int>(i);
    const int at_rest = rest.samplesAt(at % film.width(), at / film.width());
    const int due = at_rest > 0 ? at_rest : picture.samples;
    picture.nonfinite_pixels += texels[i].a < static_cast<float>(due);
  }
  addKept(picture, tracer, texels);
  return picture;
}

Losses readLosses(const PathTracer& tracer, const Rest& rest) {
  Losses losses;
  const int width = tracer.film().width();
  const std::vector<Vec4> texels = tracer.film().radiance.front().readFloats();
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const auto at = static_cast<int>(i);
    if (rest.samplesAt(at % width, at / width) > 0) continue;
    // As light.glsl marks them, and as sample_mean.glsl asks.
    const Vec4& texel = texels[i];
    const bool marked = std::min({texel.r, texel.g, texel.b}) < 0;
    const bool good = texel.r + texel.g + texel.b <= 1e30f;
    losses.cut_short += marked;
    losses.not_finite += !marked && !good;
  }
  return losses;
}

FirstHits readFirstHits(PathTracer& tracer, int rays) {
  const Film& film = tracer.film();
  const Camera& camera = tracer.camera();
  const Vec3 forward = CameraFrame(camera).forward;
  const auto count = static_cast<std::size_t>(film.width()) * film.height();
  FirstHits hits{std::vector<Vec3>(count),
                 std::vector<Vec3>(count),
                 std::vector<float>(count),
                 {},
                 std::vector<float>(count)};
  const auto texelsOf = [&](int ray, int wanted) {
    return fromTop<Vec4>(tracer.firstHits(ray, wanted), film, [](const Vec4& v) { return v; });
  };
  for (int ray = 0; ray < rays; ++ray) {
    const std::vector<Vec4> albedo = texelsOf(ray, 0);
    const std::vector<Vec4> normal = texelsOf(ray, 1);
    const std::vector<Vec4> place = texelsOf(ray, 2);
    for (std::size_t i = 0; i < count; ++i) {
      if (ray == 0) hits.material.push_back(place[i].a);
      if (!(albedo[i].a > 0)) continue;
      hits.coverage[i] += 1;
      hits.albedo[i] += Vec3(albedo[i]);
      hits.normal[i] += Vec3(normal[i]);
      hits.depth[i] += glm::dot(Vec3(place[i]) - camera.position, forward);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const float met = std::max(hits.coverage[i], 1.0f);
    hits.albedo[i] /= met;
    hits.normal[i] /= met;
    hits.depth[i] /= met;
    hits.coverage[i] /= static_cast<float>(rays);
  }
  return hits;
}

Image readDenoised(Image picture, const gl::Target& denoised) {
  picture.pixels =
      fromTop<Vec3>(denoised.readFloats(), denoised, [](const Vec4& texel) { return Vec3(texel); });
  picture.denoised = true;
  return picture;
}

DisplayImage readDisplay(const gl::Target& target) {
  const std::vector<unsigned char> bytes = target.readBytes();
  DisplayImage image{target.width(), target.height(), {}};
  image.bytes.resize(bytes.size() / 4 * 3);
  std::uint8_t* to = image.bytes.data();
  for (int y = image.height - 1; y >= 0; --y) {  // GL's rows begin at the bottom
    const unsigned char* from = &bytes[static_cast<std::size_t>(y) * image.width * 4];
    for (int x = 0; x < image.width; ++x, from += 4) to = std::copy_n(from, 3, to);
  }
  return image;
}

}  // namespace glimt
