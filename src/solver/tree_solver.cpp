#include "solver/tree_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solver/intersection_tree.h"
#include "solver/tree_shadings.h"

namespace goniolux::solver {
namespace {

using core::Vec3;

// Discarded bounds are summed as whole numbers of this many cd/m2, so that the sum does not depend on the order.
constexpr double discardedUnit = 1e-9;
// Points chosen on each luminous opening for a sample of the illuminance.
constexpr std::uint64_t lightStream = 0x7ee;

class TreeSolver final : public Solver {
 public:
  explicit TreeSolver(const Problem& problem)
      : world_(problem.world),
        tracer_(problem.tracer),
        settings_(problem.tree),
        nodes_(problem.quadrature.wavelengths.size()),
        shadings_(makeShadings(problem.world, problem.quadrature, problem.tree)),
        lighting_(treeLighting(problem.world, problem.quadrature, problem.tree)),
        scale_(luminanceScale(problem.world)),
        builder_(world_, tracer_, shadings_, nodes_, nodes_ / 2,
                 {settings_.maxDepth, settings_.cutoff, settings_.adaptive}, scale_) {
    if (lighting_.ambient.empty()) return;
    for (std::size_t s = 0; s < lighting_.weights.size(); ++s)
      for (std::size_t k = 0; k < nodes_; ++k)
        for (std::size_t c = 0; c < ambientResponse_.size(); ++c)
          ambientResponse_[c] += lighting_.ambient[k] * lighting_.ambientShare[s] * lighting_.weights[s][k][c];
  }

  [[nodiscard]] std::unique_ptr<ReceiverPlan> plan(const Receiver&, std::uint64_t) const override {
    return std::make_unique<ReceiverPlan>();
  }

  // Direct light of every source, and the ambient term over the hemisphere.
  [[nodiscard]] Response illuminance(const Receiver& receiver, const ReceiverPlan&, std::uint64_t key,
                                     std::uint32_t samples) const override {
    const Vec3 start = tracer_.leave(receiver.point, receiver.normal);
    Response result{};
    std::uint64_t rays = 0;
    for (std::uint32_t i = 0; i < world_.emitters.size(); ++i) {
      const scene::LightSource& source = world_.emitters[i];
      if (!receiver.directLight) break;
      if (receiver.isPlane() && source.emitter->importance(receiver.point, receiver.normal) == 0) continue;
      double sum = 0;
      for (std::uint32_t s = 0; s < samples; ++s) {
        core::Sampler random(core::combine(core::combine(key, lightStream), i), s);
        const emitter::IncidentLight light = source.emitter->sample(receiver.point, random.next2());
        const double answer = light.normalIlluminance > 0 ? receiver.response(light.direction) : 0;
        if (answer <= 0) continue;
        sum += light.normalIlluminance * answer *
               builder_.seen(source, start, receiver.point + light.direction * light.distance, rays);
      }
      for (std::size_t c = 0; c < result.size(); ++c)
        for (std::size_t k = 0; k < nodes_; ++k) result[c] += sum / samples * lighting_.weights[source.spectrum][k][c];
    }
    for (std::size_t c = 0; c < result.size(); ++c) result[c] += core::pi * ambientResponse_[c];
    rays_.fetch_add(rays, std::memory_order_relaxed);
    return result;
  }

  [[nodiscard]] Response radiance(const Vec3& origin, const Vec3& direction, std::uint64_t key,
                                  std::uint32_t sample) const override {
    thread_local IntersectionTree tree;
    core::Sampler random(core::combine(key, lightStream), sample);
    builder_.build(origin, direction, random, tree);
    rays_.fetch_add(tree.rays, std::memory_order_relaxed);
    trees_.fetch_add(1, std::memory_order_relaxed);
    treeNodes_.fetch_add(tree.nodes.size(), std::memory_order_relaxed);
    const double units = std::min(tree.discarded / discardedUnit, 1e15);
    discarded_.fetch_add(static_cast<std::uint64_t>(units), std::memory_order_relaxed);
    std::int32_t deepest = deepest_.load(std::memory_order_relaxed);
    while (tree.deepest > deepest && !deepest_.compare_exchange_weak(deepest, tree.deepest)) {
    }
    return evaluate(tree, shadings_, lighting_, world_);
  }

  [[nodiscard]] std::vector<std::string> leftOut() const override {
    std::vector<std::string> sentences = {
        "interreflection between matt surfaces (solver tree), but for the ambient term I_a",
        "light that reaches matt surfaces by mirrors or through solid glass (solver tree)"};
    for (const material::Material& material : world_.materials)
      if (reflection::findShadingModel(material.model) != nullptr || settings_.reflectionModel != "material") {
        sentences.emplace_back(
            "energy conservation: phong, whitted and hall are not normalised; pictures by them are no photometric "
            "measurement");
        break;
      }
    for (const material::Material& material : world_.materials)
      if (material.texture) {
        sentences.emplace_back("textures (solver tree): a textured finish is its mean everywhere");
        break;
      }
    return sentences;
  }

  [[nodiscard]] std::vector<Statistic> statistics() const override {
    const auto trees = static_cast<double>(std::max<std::uint64_t>(1, trees_.load()));
    return {{"average_tree_depth", static_cast<double>(treeNodes_.load()) / trees, "nodes per tree"},
            {"maximum_tree_depth", static_cast<double>(deepest_.load()), ""},
            {"trees", static_cast<double>(trees_.load()), ""},
            {"nodes", static_cast<double>(treeNodes_.load()), ""},
            {"truncation", static_cast<double>(discarded_.load()) * discardedUnit / trees,
             "cd/m2: mean bound of the nodes left out"}};
  }

 private:
  const scene::World& world_;
  const tracer::Tracer& tracer_;
  TreeSettings settings_;
  std::size_t nodes_;
  Shadings shadings_;
  TreeLighting lighting_;
  LuminanceScale scale_;
  TreeBuilder builder_;
  Response ambientResponse_{};
  mutable std::atomic<std::uint64_t> trees_{0}, treeNodes_{0}, discarded_{0};
  mutable std::atomic<std::int32_t> deepest_{0};
};

}  // namespace

Shadings makeShadings(const scene::World& world, const spectrum::SpectralQuadrature& quadrature,
                      const TreeSettings& settings) {
  Shadings shadings;
  for (const material::Material& given : world.materials) {
    const bool force = settings.reflectionModel != "material";
    const material::Material material = force ? reflection::inPaperTerms(given, settings.reflectionModel) : given;
    const std::string& name = force ? settings.reflectionModel : material.model;
    if (const reflection::ShadingModel* model = reflection::findShadingModel(name)) {
      shadings.push_back(model->make(material, quadrature, settings.asPrinted));
      continue;
    }
    const reflection::ReflectionModel* model = reflection::findReflectionModel(name);
    if (model == nullptr) throw std::invalid_argument("no reflection model \"" + name + "\"");
    shadings.push_back(reflection::shadingOf(model->make(material, quadrature), quadrature.wavelengths.size()));
  }
  return shadings;
}

TreeLighting treeLighting(const scene::World& world, const spectrum::SpectralQuadrature& quadrature,
                          const TreeSettings& settings) {
  TreeLighting lighting;
  lighting.weights = quadrature.weights;
  lighting.ambientShare.assign(quadrature.weights.size(), 0.0);
  if (!(settings.ambient.range().second > 0)) return lighting;
  lighting.ambient = spectrum::atNodes(settings.ambient, quadrature);
  double total = 0;
  for (const scene::LightSource& source : world.emitters) {
    lighting.ambientShare[source.spectrum] += source.emitter->flux();
    total += source.emitter->flux();
  }
  // The ambient light has the colour of all lamps together, times the spectrum given.
  for (double& share : lighting.ambientShare) share = total > 0 ? share / total : 0;
  if (!(total > 0) && !lighting.ambientShare.empty()) lighting.ambientShare.front() = 1;
  return lighting;
}

std::unique_ptr<Solver> makeTreeSolver(const Problem& problem) {
  return std::make_unique<TreeSolver>(problem);
}

}  // namespace goniolux::solver
