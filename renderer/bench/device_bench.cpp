#include <algorithm>

#include "renderer/bench.h"
#include "renderer/bench/bench_mesh.h"
#include "renderer/bench/device_ceilings.h"
#include "renderer/bench/device_work.h"
#include "renderer/bench/mesh_rays.h"
#include "renderer/bench/ray_work.h"
#include "renderer/core/wording.h"
#include "renderer/gl/context.h"

namespace glimt {
namespace {

using Question = TraversalProgram::Question;

// The best of the pictures' sizes.
double ceilingOf(const std::vector<DeviceRow>& ceilings, const std::string& work) {
  double best = 0;
  for (const DeviceRow& row : ceilings)
    if (row.work == work && row.rate) best = std::max(best, row.rate->median);
  return best;
}

// Camera rays stay side by side; the others soon want texels that have nothing to do with each
// other. All of them meet the upper levels of the tree most often, which the nearest cache holds.
double fetchCeilingOf(const std::vector<DeviceRow>& ceilings, std::size_t kind) {
  if (kind > 0) return ceilingOf(ceilings, randomTexelsWork(kSmallTexture).name);
  return std::max(ceilingOf(ceilings, sameTexelWork().name),
                  ceilingOf(ceilings, neighboursWork().name));
}

RayWork meanOf(const std::vector<RayWork>& works, const Rays& rays) {
  RayWork sum;
  for (std::size_t i = 0; i < works.size(); ++i) {
    if (!rays.live(i)) continue;
    sum.node_fetches += works[i].node_fetches;
    sum.triangle_fetches += works[i].triangle_fetches;
    sum.box_tests += works[i].box_tests;
    sum.triangle_tests += works[i].triangle_tests;
  }
  const double count = std::max(1.0, static_cast<double>(rays.countLive()));
  return {sum.node_fetches / count, sum.triangle_fetches / count, sum.box_tests / count,
          sum.triangle_tests / count};
}

class BoundBench {
 public:
  BoundBench(const gl::Device& device, const DeviceBenchSettings& settings,
             const std::vector<DeviceRow>& ceilings)
      : device_(&device),
        ceilings_(&ceilings),
        side_(settings.ray_side),
        scene_(makeBenchMesh(settings.triangles)),
        rays_(makeMeshRays(device, scene_, texturesFor("skip"), side_)) {}

  // Adds a row for each kind of ray.
  void add(const TraversalRow& measured, std::vector<TraversalBoundRow>& rows) const {
    const SceneTextures textures = texturesFor(measured.traversal);
    for (std::size_t kind = 0; kind < kRayKinds.size(); ++kind) {
      const RayTextures rays(*device_, rays_[kind], side_);
      const Question question = kind == kShadowRays ? Question::visibility : Question::closest_hit;
      const RayWork per_ray =
          meanOf(countRayWork(*device_, measured.traversal, question, textures, rays), rays_[kind]);
      rows.push_back(boundOf(measured, kind, per_ray));
    }
  }

 private:
  SceneTextures texturesFor(const std::string& traversal) const {
    return {*device_, scene_, traversalNamed(traversal).layout};
  }

  TraversalBoundRow boundOf(const TraversalRow& measured, std::size_t kind,
                            const RayWork& per_ray) const {
    TraversalBoundRow row;
    row.triangles = measured.triangles;
    row.traversal = measured.traversal;
    row.rays = kRayKinds[kind];
    row.per_ray = per_ray;
    row.rate = (*measured.rates)[kind];
    row.fetch_ceiling = fetchCeilingOf(*ceilings_, kind);
    row.fetch_bound = 1000 * row.fetch_ceiling / per_ray.fetches();
    const bool ordered = traversalNamed(row.traversal).layout == TreeLayout::octants;
    const double nanoseconds =
        per_ray.box_tests / ceilingOf(*ceilings_, ordered ? kOrderedBoxWork : kBoxWork) +
        per_ray.triangle_tests / ceilingOf(*ceilings_, kTriangleWork);
    row.arithmetic_bound = 1000 / nanoseconds;
    return row;
  }

  const gl::Device* device_;
  const std::vector<DeviceRow>* ceilings_;
  int side_;
  Scene scene_;
  MeshRays rays_;
};

}  // namespace

DeviceBench benchDevice(ContextHandle& context, const DeviceBenchSettings& settings,
                        const std::function<void(const std::string&)>& progress) {
  const gl::Device device(context.get());
  DeviceBench bench;
  bench.ceilings = measureCeilings(device, settings, progress);
  const TraversalBenchSettings traversals{
      {settings.triangles}, settings.ray_side, settings.repeats};
  const std::vector<TraversalRow> measured = benchTraversals(context, traversals, progress);
  progress("counting fetches");
  const BoundBench bounds(device, settings, bench.ceilings);
  for (const TraversalRow& row : measured)
    if (row.traversal != kEmbree && row.rates) bounds.add(row, bench.bounds);
  return bench;
}

}  // namespace glimt
