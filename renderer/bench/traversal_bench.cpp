#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "renderer/bench.h"
#include "renderer/bench/bench_mesh.h"
#include "renderer/bench/bench_rays.h"
#include "renderer/bench/hit_comparison.h"
#include "renderer/bench/stopwatch.h"
#include "renderer/bench/traversal_program.h"
#include "renderer/core/error.h"
#include "renderer/core/wording.h"
#include "renderer/gl/context.h"
#ifdef GLIMT_EMBREE
#include "renderer/bench/embree_ceiling.h"
#endif

namespace glimt {
namespace {

constexpr std::size_t kKinds = kRayKinds.size();
constexpr std::size_t kShadow = 2;  // the only kind that asks for visibility
constexpr const char* kSkip = "skip";

// llvmpipe ends loops silently after some 65,500 turns, and long before that linear is too slow to
// wait for.
constexpr std::size_t kMostTrianglesForLinear = 2000;

using Question = TraversalProgram::Question;

// A column of measurements: one way to cast the rays.
struct Measured {
  TraversalRow row;
  std::array<std::vector<double>, kKinds> seconds;
  std::array<std::vector<float>, kKinds> results;
};

// Casts the rays of a kind. Returns the seconds; results are kept where the pointer is not null.
using Cast = std::function<double(std::size_t kind, std::vector<float>* results)>;

struct Candidate {
  Measured measured;
  Cast cast;
};

// Trees in each of the layouts, made when first asked for: traversals share them.
class Trees {
 public:
  Trees(const gl::Device& device, const Scene& scene) : device_(&device), scene_(&scene) {}

  // Errors: input, where the tree does not fit.
  const SceneTextures& of(const std::string& traversal) {
    const TreeLayout layout = traversalNamed(traversal).layout;
    const auto found = made_.find(layout);
    if (found != made_.end()) return found->second;
    return made_.try_emplace(layout, *device_, *scene_, layout).first->second;
  }

 private:
  const gl::Device* device_;
  const Scene* scene_;
  std::map<TreeLayout, SceneTextures> made_;
};

std::vector<float> distancesOf(const std::vector<Vec4>& results) {
  std::vector<float> distances;
  distances.reserve(results.size());
  for (const Vec4& result : results) distances.push_back(result.w);
  return distances;
}

Rate rateOf(const std::vector<double>& seconds, std::size_t rays) {
  const double million = static_cast<double>(rays) / 1e6;
  const Spread spread = spreadOf(seconds);
  return {million / spread.median, million / spread.most, million / spread.least};
}

class MeshBench {
 public:
  using Progress = std::function<void(const std::string&)>;

  MeshBench(const gl::Device& device, std::size_t triangles, const TraversalBenchSettings& settings,
            const Progress& progress)
      : device_(&device), settings_(&settings), progress_(&progress) {
    tell("making {} triangles", grouped(triangles));
    scene_ = makeBenchMesh(triangles);
  }

  std::vector<TraversalRow> run() {
    Trees trees(*device_, scene_);
    makeRays(trees.of(kSkip));
    addEmbree();
    for (const Traversal& traversal : traversals()) addTraversal(traversal.name, trees);
    measure();
    return rows();
  }

 private:
  template <typename... Values>
  void tell(fmt::format_string<Values...> format, Values&&... values) const {
    (*progress_)(fmt::format(format, std::forward<Values>(values)...));
  }

  // The camera's hits, from which the others start, are those of traversal "skip": it takes any
  // tree.
  void makeRays(const SceneTextures& tree) {
    const int side = settings_->side;
    rays_[0] = makeCameraRays(scene_.camera, side);
    const RayTextures camera(*device_, rays_[0], side);
    TraversalProgram(*device_, kSkip, Question::closest_hit).run(tree, camera);
    const std::vector<SurfaceHit> hits = readResults(camera);
    rays_[1] = makeBounceRays(rays_[0], hits);
    rays_[kShadow] = makeShadowRays(rays_[0], hits);
    for (const Rays& rays : rays_) textures_.emplace_back(*device_, rays, side);
  }

  TraversalRow newRow(const std::string& traversal) const {
    TraversalRow row;
    row.scene = scene_.name;
    row.triangles = scene_.triangles.size();
    row.traversal = traversal;
    return row;
  }

  void addEmbree() {
#ifdef GLIMT_EMBREE
    tell("{} triangles: Embree's tree", grouped(scene_.triangles.size()));
    const auto embree = std::make_shared<EmbreeCeiling>(scene_);
    Measured measured{newRow(kEmbree), {}, {}};
    measured.row.bvh_seconds = embree->buildSeconds();
    const Cast cast = [this, embree](std::size_t kind, std::vector<float>* results) {
      const auto start = std::chrono::steady_clock::now();
      auto found =
          kind == kShadow ? embree->visibilities(rays_[kind]) : embree->closestHits(rays_[kind]);
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      if (results != nullptr) *results = std::move(found);
      return seconds.count();
    };
    candidates_.push_back({std::move(measured), cast});
#endif
  }

  void addTraversal(const std::string& name, Trees& trees) {
    if (name == "linear" && scene_.triangles.size() > kMostTrianglesForLinear) return;
    tell("{} triangles: tree and shaders of {}", grouped(scene_.triangles.size()), name);
    Measured measured{newRow(name), {}, {}};
    try {
      const SceneTextures& tree = trees.of(name);
      checkFits(traversalNamed(name), tree.stackSize());
      const Cast cast = castOn(name, tree, measured.row);
      candidates_.push_back({measured, cast});
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::input) throw;
      measured.row.note = error.what();
      unfit_.push_back(measured.row);
    }
  }

  // Fills in what is known of the traversal before it casts a ray.
  Cast castOn(const std::string& name, const SceneTextures& tree, TraversalRow& row);

  // Repeats go round the candidates, so that a slow moment of the machine is not one candidate's.
  void measure() {
    for (int repeat = 0; repeat <= settings_->repeats; ++repeat) {
      tell("{} triangles: repeat {} of {}", grouped(scene_.triangles.size()), repeat,
           settings_->repeats);
      for (std::size_t kind = 0; kind < kKinds; ++kind)
        for (Candidate& candidate : candidates_) {
          std::vector<float>* const results =
              repeat == 0 ? &candidate.measured.results[kind] : nullptr;
          const double seconds = candidate.cast(kind, results);
          if (repeat > 0) candidate.measured.seconds[kind].push_back(seconds);
        }
    }
  }

  const Measured& reference() const {
    const auto named = [this](const std::string& name) {
      return std::find_if(candidates_.begin(), candidates_.end(), [&](const Candidate& candidate) {
        return candidate.measured.row.traversal == name;
      });
    };
    const auto embree = named(kEmbree);
    return (embree != candidates_.end() ? embree : named(kSkip))->measured;
  }

  TraversalRow rowOf(const Measured& measured) const {
    TraversalRow row = measured.row;
    row.reference = reference().row.traversal;
    row.rates.emplace();
    row.agrees = true;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      const std::size_t live = rays_[kind].countLive();
      const std::size_t different =
          countDifferent(rays_[kind], measured.results[kind], reference().results[kind]);
      (*row.rates)[kind] = rateOf(measured.seconds[kind], live);
      row.agrees = row.agrees && agree(different, live);
      row.different += different;
      row.compared += live;
    }
    return row;
  }

  std::vector<TraversalRow> rows() const {
    std::vector<TraversalRow> rows;
    for (const Candidate& candidate : candidates_) rows.push_back(rowOf(candidate.measured));
    rows.insert(rows.end(), unfit_.begin(), unfit_.end());
    return rows;
  }

  const gl::Device* device_;
  const TraversalBenchSettings* settings_;
  const Progress* progress_;
  Scene scene_;
  std::array<Rays, kKinds> rays_;
  std::vector<RayTextures> textures_;
  std::vector<Candidate> candidates_;
  std::vector<TraversalRow> unfit_;
};

Cast MeshBench::castOn(const std::string& name, const SceneTextures& tree, TraversalRow& row) {
  // Shared, since a std::function is copied and programs are not.
  const auto closest = std::make_shared<TraversalProgram>(*device_, name, Question::closest_hit);
  const auto visible = std::make_shared<TraversalProgram>(*device_, name, Question::visibility);
  row.compile_seconds = closest->compileSeconds(tree, textures_[0]) +
                        visible->compileSeconds(tree, textures_[kShadow]);
  row.gpu_bytes_per_triangle =
      static_cast<double>(tree.bytes()) / static_cast<double>(scene_.triangles.size());
  row.bvh_seconds = tree.buildSeconds();
  return [this, closest, visible, &tree](std::size_t kind, std::vector<float>* results) {
    TraversalProgram& program = kind == kShadow ? *visible : *closest;
    const double seconds = program.run(tree, textures_[kind]);
    if (results != nullptr) *results = distancesOf(readResults(textures_[kind]));
    return seconds;
  };
}

}  // namespace

std::vector<TraversalRow> benchTraversals(ContextHandle& context,
                                          const TraversalBenchSettings& settings,
                                          const std::function<void(const std::string&)>& progress) {
  const gl::Device device(context.get());
  std::vector<TraversalRow> rows;
  for (const std::size_t triangles : settings.triangles) {
    const auto more = MeshBench(device, triangles, settings, progress).run();
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace glimt
