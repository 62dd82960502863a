// Study of web resolution: candela tables thinned out until the answer moves. Direct illuminances of the grids, nothing
// between, so that no chance is involved.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/parallel.h"
#include "emitter/emitter.h"
#include "pipeline/engine.h"
#include "pipeline/study_choices.h"

namespace goniolux::pipeline {
namespace {

using photometry::TabulatedDistribution;

constexpr std::size_t mostPoints = 200;
constexpr double leastShare = 0.1;     // a point below this share of the mean is judged by it, as accuracy is asked for
constexpr double drawnAtLeast = 1e-3;  // %, the axis is logarithmic
constexpr double tolerance = 1e-4;     // of quadrature over openings

/// Every `step`-th angle, and the last.
std::vector<std::size_t> kept(std::size_t count, std::size_t step, bool keepsLast) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < count; i += step) indices.push_back(i);
  if (keepsLast && indices.back() != count - 1) indices.push_back(count - 1);
  return indices;
}

/// nullptr where the thinned planes cover the sphere in no known way.
std::shared_ptr<const TabulatedDistribution> thinned(const TabulatedDistribution& table, std::size_t planeStep,
                                                     std::size_t angleStep) {
  const auto& planes = table.horizontalAngles();
  // Without symmetry a table may leave out the plane of 360 degrees: then its last one is no end.
  const bool closed = planes.size() > 1 && (table.symmetry() != photometry::HorizontalSymmetry::none ||
                                            planes.back() - planes.front() >= 360);
  const auto h = kept(planes.size(), planeStep, closed), v = kept(table.verticalAngles().size(), angleStep, true);
  std::vector<double> horizontal, vertical, candelas;
  for (const std::size_t i : h) horizontal.push_back(planes[i]);
  for (const std::size_t j : v) vertical.push_back(table.verticalAngles()[j]);
  for (const std::size_t i : h)
    for (const std::size_t j : v) candelas.push_back(table.candela(i, j));
  if (horizontal.size() > 1 && photometry::horizontalSymmetry(table.type(), horizontal) != table.symmetry())
    return nullptr;
  return std::make_shared<TabulatedDistribution>(table.type(), horizontal, vertical, candelas);
}

struct Place {
  core::Vec3 point, normal;
};

std::vector<Place> placesOf(const project::Project& project) {
  std::vector<Place> places;
  std::size_t all = 0;
  for (const auto& grid : project.grids) all += grid.points.size();
  const std::size_t step = std::max<std::size_t>(1, all / mostPoints);
  std::size_t counted = 0;
  for (const auto& grid : project.grids)
    for (std::size_t i = 0; i < grid.points.size(); ++i)
      if (counted++ % step == 0) places.push_back({grid.points[i], grid.normals[i]});
  return places;
}

/// Direct illuminances of the places, and the flux; nothing where a table cannot be thinned so.
struct Found {
  std::vector<double> lx;
  double lumens = 0;
};
std::optional<Found> calculate(const project::Project& project, const std::vector<Place>& places, std::size_t planeStep,
                               std::size_t angleStep) {
  std::map<const photometry::IntensityDistribution*, std::shared_ptr<const TabulatedDistribution>> made;
  std::vector<std::unique_ptr<emitter::Emitter>> emitters;
  Found found;
  for (const scene::Luminaire& luminaire : project.environment.luminaires) {
    const auto* table = dynamic_cast<const TabulatedDistribution*>(luminaire.distribution.get());
    emitter::Output output;
    output.distribution = luminaire.distribution;
    if (table != nullptr) {
      auto& own = made[table];
      if (!own) own = thinned(*table, planeStep, angleStep);
      if (!own) return std::nullopt;
      output.distribution = own;
    }
    output.frame = luminaire.frame;
    output.scale = luminaire.scale * luminaire.dimming;
    output.flux_lm = luminaire.flux_lm * luminaire.dimming;
    emitters.push_back(emitter::makeEmitter(luminaire.opening, luminaire.center, output));
    found.lumens += emitters.back()->flux();
  }
  found.lx.assign(places.size(), 0);
  core::parallelFor(places.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (const auto& each : emitters)
        found.lx[i] += each->illuminance(places[i].point, places[i].normal, tolerance).value;
  });
  return found;
}

double meanStep(const std::vector<double>& angles, std::size_t step) {
  return angles.size() < 2
             ? 0
             : static_cast<double>(step) * (angles.back() - angles.front()) / static_cast<double>(angles.size() - 1);
}

ChoiceResult run(const project::Project& project, core::ProgressSink& progress) {
  const TabulatedDistribution* finest = nullptr;
  for (const scene::Luminaire& luminaire : project.environment.luminaires)
    if (const auto* table = dynamic_cast<const TabulatedDistribution*>(luminaire.distribution.get()))
      if (finest == nullptr || table->verticalAngles().size() * table->horizontalAngles().size() >
                                   finest->verticalAngles().size() * finest->horizontalAngles().size())
        finest = table;
  if (finest == nullptr)
    nothingToStudy(project, "no luminaire has a table of candelas: built-in distributions have no angles to leave out");
  if (project.grids.empty()) nothingToStudy(project, "the project has no grid on which a change could show; add one");
  const std::vector<Place> places = placesOf(project);
  const Found whole = calculate(project, places, 1, 1).value();
  double mean = 0;
  for (const double lx : whole.lx) mean += lx / static_cast<double>(places.size());
  if (!(mean > 0)) nothingToStudy(project, "no direct light falls on the grids");

  ChoiceResult result;
  result.columns = {"thinned", "every", "step_degrees", "largest_percent", "rms_percent", "flux_percent"};
  plot::LineChart& chart = result.chart;
  chart.title = project.name;
  chart.subtitle = "Candela tables thinned out: change of direct illuminance on the grids";
  chart.x = {"step of the angles / degrees", true};
  chart.y = {"change / %", true};
  chart.guides = {1};
  std::string holds;
  for (const bool planes : {false, true}) {
    const auto& angles = planes ? finest->horizontalAngles() : finest->verticalAngles();
    const std::string name = planes ? "C planes" : "γ angles";
    for (std::size_t step = 2; step < angles.size(); step *= 2) {
      progress.progress(project.name, 0.5 * planes, fmt::format("{}: every {}th", name, step));
      if (progress.cancelled()) return result;
      const auto found = calculate(project, places, planes ? step : 1, planes ? 1 : step);
      if (!found) continue;
      double squares = 0, largest = 0;
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double error = (found->lx[i] - whole.lx[i]) / std::max(whole.lx[i], leastShare * mean);
        squares += error * error;
        largest = std::max(largest, std::abs(error));
      }
      const double rms = std::sqrt(squares / static_cast<double>(places.size())), degrees = meanStep(angles, step);
      addPoint(chart, name + ", largest", degrees, std::max(100 * largest, drawnAtLeast));
      addPoint(chart, name + ", RMS", degrees, std::max(100 * rms, drawnAtLeast));
      result.rows.push_back({planes ? "C" : "gamma", fmt::format("{}", step), fmt::format("{:.4g}", degrees),
                             fmt::format("{:.4g}", 100 * largest), fmt::format("{:.4g}", 100 * rms),
                             fmt::format("{:+.4g}", 100 * (found->lumens / whole.lumens - 1))});
      if (largest < 0.01) holds = fmt::format("{} every {:.3g}° still hold 1 % everywhere", name, degrees);
    }
    if (!holds.empty()) chart.facts.push_back(std::exchange(holds, ""));
  }
  if (chart.curves.empty())
    nothingToStudy(project, "the tables of the luminaires have too few angles to leave any out");
  chart.footer =
      fmt::format("goniolux {} · tables of up to {} × {} angles · {} points · grey line: 1 %", programVersion(),
                  finest->horizontalAngles().size(), finest->verticalAngles().size(), places.size());
  return result;
}

}  // namespace

ChoiceStudy webResolutionStudy() {
  return {
      "web-resolution", "angles of the candela tables",
      "change of the grids' direct illuminance when only every second, fourth ... angle of gamma, or plane of C, is "
      "kept",
      run};
}

}  // namespace goniolux::pipeline
