// Study of interreflection depth: how much light is missing when paths are ended after n reflections. Paths of its own,
// from a few points of the grids, without Russian roulette: what each reflection adds is kept apart.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/parallel.h"
#include "core/random.h"
#include "pipeline/engine.h"
#include "pipeline/study_choices.h"
#include "reflection/bsdf.h"
#include "solver/directions.h"

namespace goniolux::pipeline {
namespace {

using core::Vec3;

constexpr std::size_t mostPoints = 48;
constexpr std::uint32_t pathsPerPoint = 512;
constexpr std::size_t mostBounces = 64;
constexpr double drawnAtLeast = 1e-2;  // %, the axis is logarithmic
constexpr double leastThroughput = 1e-7;

using Series = std::array<double, mostBounces + 1>;  // lx that arrive after exactly n reflections

class BounceTracer {
 public:
  explicit BounceTracer(const Engine& engine) : world_(engine.world), tracer_(engine.tracer), plan_(engine.plan) {
    for (const material::Material& material : world_.materials)
      finishes_.push_back(reflection::findReflectionModel(material.model)->make(material, plan_.quadrature));
  }
  [[nodiscard]] bool hasBodies() const {
    return std::any_of(finishes_.begin(), finishes_.end(), [](const auto& each) { return each->medium() != nullptr; });
  }
  [[nodiscard]] bool hasMirrors() const {
    return std::any_of(finishes_.begin(), finishes_.end(), [](const auto& each) { return each->lobes().single; });
  }

  /// Adds one path from a receiver.
  void addPath(Series& series, const Vec3& point, const Vec3& normal, core::Sampler& random) const {
    Vec3 start = tracer_.leave(point, normal);
    const std::vector<float> whole(nodes(), 1.0f);
    series[0] += fromLights(
        start, normal, random,
        [&](const Vec3&, double cosine, std::vector<float>& values) {
          std::fill(values.begin(), values.end(), static_cast<float>(cosine));
        },
        whole);
    Vec3 direction = solver::cosineDirection(solver::frameAbout(normal), random.next2());
    std::vector<float> throughput(nodes(), static_cast<float>(core::pi));
    bool single = false;  // the last direction was a single one: light that it meets was not looked for
    tracer::Hit hit;
    for (std::size_t bounce = 1; bounce <= mostBounces && tracer_.intersect(start, direction, hit); ++bounce) {
      const scene::Surface& surface = world_.surfaces[hit.surface];
      const Vec3 facing = glm::dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal;
      if (single) series[bounce - 1] += emitted(surface, facing, -direction, throughput);
      if (surface.material == scene::none) return;
      const reflection::Bsdf& finish = *finishes_[surface.material];
      const core::Frame frame = solver::frameAbout(facing);
      const Vec3 out = frame.toLocal(-direction);
      start = tracer_.leave(hit.position, facing);
      if (finish.lobes().spread)
        series[bounce] += fromLights(
            start, facing, random,
            [&](const Vec3& to, double cosine, std::vector<float>& values) {
              finish.evaluate(out, frame.toLocal(to), {}, values.data());
              for (float& value : values) value *= static_cast<float>(cosine);
            },
            throughput);
      reflection::BsdfSample chosen;
      std::vector<float> weight(nodes());
      if (!finish.sample(out, random.next2(), {}, chosen, weight.data())) return;
      float largest = 0;
      for (std::size_t k = 0; k < nodes(); ++k) largest = std::max(largest, throughput[k] *= weight[k]);
      if (static_cast<double>(largest) < leastThroughput) return;
      if (chosen.direction.z < 0) start = tracer_.leave(hit.position, -facing);
      direction = frame.toWorld(chosen.direction);
      single = chosen.specular;
    }
  }

 private:
  [[nodiscard]] std::size_t nodes() const { return plan_.quadrature.wavelengths.size(); }

  [[nodiscard]] double photopic(std::uint32_t spectrum, const std::vector<float>& throughput) const {
    double sum = 0;
    for (std::size_t k = 0; k < nodes(); ++k)
      sum += plan_.quadrature.weights[spectrum][k][1] * static_cast<double>(throughput[k]);
    return sum;
  }

  /// Light of one emitter, chosen by what each might give; `scatter` turns direction and cosine into a factor a node.
  template <typename Scatter>
  double fromLights(const Vec3& point, const Vec3& normal, core::Sampler& random, const Scatter& scatter,
                    const std::vector<float>& throughput) const {
    double total = 0;
    std::vector<double> importance(world_.emitters.size());
    for (std::size_t i = 0; i < importance.size(); ++i)
      total += importance[i] = world_.emitters[i].emitter->importance(point, normal);
    const double u = random.next() * total;
    const core::Vec2 where = random.next2();
    if (!(total > 0)) return 0;
    std::size_t chosen = 0;
    for (double sum = importance[0]; sum < u && chosen + 1 < importance.size(); sum += importance[++chosen]) {
    }
    const scene::LightSource& light = world_.emitters[chosen];
    const emitter::IncidentLight incident = light.emitter->sample(point, where);
    const double cosine = glm::dot(incident.direction, normal);
    if (cosine <= 0 || incident.normalIlluminance <= 0 ||
        tracer_.occluded(point, incident.direction, incident.distance - tracer_.slack()))
      return 0;
    std::vector<float> values(nodes());
    scatter(incident.direction, cosine, values);
    for (std::size_t k = 0; k < nodes(); ++k) values[k] *= throughput[k];
    return photopic(light.spectrum, values) * incident.normalIlluminance * total / importance[chosen];
  }

  [[nodiscard]] double emitted(const scene::Surface& surface, const Vec3& facing, const Vec3& towards,
                               const std::vector<float>& throughput) const {
    if (surface.luminance > 0) return surface.luminance * photopic(surface.spectrum, throughput);
    if (surface.emitter == scene::none) return 0;
    const scene::LightSource& source = world_.emitters[surface.emitter];
    return source.emitter->luminance(facing, towards) * photopic(source.spectrum, throughput);
  }

  const scene::World& world_;
  const tracer::Tracer& tracer_;
  const planner::Plan& plan_;
  std::vector<std::unique_ptr<reflection::Bsdf>> finishes_;
};

ChoiceResult run(const project::Project& project, core::ProgressSink& progress) {
  std::vector<std::pair<Vec3, Vec3>> points;
  std::size_t all = 0, counted = 0;
  for (const auto& grid : project.grids) all += grid.points.size();
  if (all == 0) nothingToStudy(project, "the project has no grid whose light could be counted by reflections; add one");
  const Engine engine(project, false);
  for (const auto& grid : project.grids)
    for (std::size_t i = 0; i < grid.points.size(); ++i)
      if (counted++ % std::max<std::size_t>(1, all / mostPoints) == 0)
        points.emplace_back(grid.points[i] - engine.world.origin, grid.normals[i]);
  const BounceTracer tracer(engine);
  if (tracer.hasBodies())
    nothingToStudy(project, "the project has bodies of glass or water, whose refractions this study does not count");
  std::vector<Series> series(points.size(), Series{});
  progress.progress(project.name, 0,
                    fmt::format("{} paths of up to {} reflections", points.size() * pathsPerPoint, mostBounces));
  core::parallelFor(points.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !progress.cancelled(); ++i)
      for (std::uint32_t path = 0; path < pathsPerPoint; ++path) {
        core::Sampler random(core::combine(project.settings.seed, i + 1), path);
        tracer.addPath(series[i], points[i].first, points[i].second, random);
      }
  });
  ChoiceResult result;
  if (progress.cancelled()) return result;
  Series sum{};
  for (const Series& one : series)
    for (std::size_t n = 0; n <= mostBounces; ++n)
      sum[n] += one[n] / pathsPerPoint / static_cast<double>(points.size());
  double total = 0;
  for (const double lx : sum) total += lx;
  if (!(total > 0)) nothingToStudy(project, "no light falls on the grids");
  // Late reflections follow each other in one ratio: what the paths of 64 leave out.
  double early = 0, late = 0;
  for (std::size_t n = 4; n < 12; ++n) early += sum[n], late += sum[n + 1];
  const double ratio = early > 0 ? std::min(0.999, late / early) : 0;
  const double tail = sum[mostBounces] * ratio / (1 - ratio);
  total += tail;
  const double indirect = total - sum[0];

  result.columns = {"reflections", "added_lx", "missing_of_all_percent", "missing_of_indirect_percent"};
  plot::LineChart& chart = result.chart;
  chart.title = project.name;
  chart.subtitle = "Light on the grids that is missing when paths end after n reflections";
  chart.x = {"reflections", false};
  chart.y = {"missing / %", true};
  chart.guides = {1};
  double known = 0;
  std::size_t enough = mostBounces;
  for (std::size_t n = 0; n <= mostBounces; ++n) {
    known += sum[n];
    const double missing = std::max(0.0, total - known);
    if (100 * missing / total >= drawnAtLeast) {
      addPoint(chart, "of all light", static_cast<double>(n), 100 * missing / total);
      if (indirect > 0) addPoint(chart, "of indirect light", static_cast<double>(n), 100 * missing / indirect);
    }
    if (missing < 0.01 * total) enough = std::min(enough, n);
    result.rows.push_back({fmt::format("{}", n), fmt::format("{:.4g}", sum[n]),
                           fmt::format("{:.4g}", 100 * missing / total),
                           indirect > 0 ? fmt::format("{:.4g}", 100 * missing / indirect) : ""});
  }
  if (chart.curves.empty()) nothingToStudy(project, "no light is reflected onto the grids: direct light is all");
  chart.facts.push_back(fmt::format("direct {:.1f} % of all; {} reflections for 1 %", 100 * sum[0] / total, enough));
  chart.facts.push_back(fmt::format("each further reflection keeps {:.1f} %", 100 * ratio));
  if (tracer.hasMirrors()) chart.facts.push_back("point luminaires seen in mirrors are not counted");
  chart.footer = fmt::format("goniolux {} · {} points, {} paths each, none ended by chance · grey line: 1 %",
                             programVersion(), points.size(), pathsPerPoint);
  return result;
}

}  // namespace

ChoiceStudy bounceStudy() {
  return {"bounces", "number of reflections",
          "share of the light on the grids that is missing when paths end after n reflections", run};
}

}  // namespace goniolux::pipeline
