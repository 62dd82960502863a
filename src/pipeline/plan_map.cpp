#include "pipeline/plan_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "plot/levels.h"
#include "plot/number_text.h"

namespace goniolux::pipeline {
namespace {

using core::Vec2;
using core::Vec3;
using project::GridPlane;
using project::GridResult;
using project::Results;

constexpr double inPlane_m = 0.05;  // outlines this near to a grid that is not horizontal are drawn in it

/// The plane of the paper in space.
struct Paper {
  Vec3 origin{0}, x{1, 0, 0}, y{0, 1, 0}, normal{0, 0, 1};
  bool isPlan = true;
  std::string xTitle = "x / m", yTitle = "y / m";
  [[nodiscard]] Vec2 onPaper(const Vec3& point) const {
    return {glm::dot(point - origin, x), glm::dot(point - origin, y)};
  }
  [[nodiscard]] double above(const Vec3& point) const { return glm::dot(point - origin, normal); }
};

/// The edges of a regular grid, from its points where the results do not state them.
std::optional<GridPlane> planeOf(const GridResult& grid) {
  if (!grid.counts) return std::nullopt;
  const auto nu = static_cast<std::size_t>((*grid.counts)[0]), nv = static_cast<std::size_t>((*grid.counts)[1]);
  std::optional<GridPlane> plane = grid.plane;
  if (!plane) {
    if (nu < 2 || nv < 2) return std::nullopt;
    const Vec3 du = grid.points[1] - grid.points[0], dv = grid.points[nu] - grid.points[0];
    plane = GridPlane{grid.points[0] - (du + dv) / 2.0, du * static_cast<double>(nu), dv * static_cast<double>(nv)};
  }
  const double area = glm::length(glm::cross(plane->u, plane->v));
  if (!(area > 1e-9 * glm::length(plane->u) * glm::length(plane->v))) return std::nullopt;
  return plane;
}

Paper paperOf(const std::optional<GridPlane>& plane) {
  Paper paper;
  if (!plane) return paper;
  const Vec3 normal = glm::normalize(glm::cross(plane->u, plane->v));
  if (std::abs(normal.z) > 0.999) {
    paper.origin = {0, 0, plane->origin.z};
    return paper;
  }
  paper.isPlan = false;
  paper.normal = normal;
  paper.x = glm::normalize(glm::cross(Vec3(0, 0, 1), normal));
  paper.y = glm::cross(normal, paper.x);
  paper.origin = plane->origin;
  const bool upright = std::abs(normal.z) < 0.001;
  if (upright) paper.origin.z = 0;
  // Distances count from the grid's leftmost corner.
  double leftmost = 0;
  for (const Vec3& edge : {plane->u, plane->v, plane->u + plane->v})
    leftmost = std::min(leftmost, glm::dot(edge, paper.x));
  paper.origin += leftmost * paper.x;
  paper.xTitle = "distance along the plane / m";
  paper.yTitle = upright ? "height z / m" : "distance up the plane / m";
  return paper;
}

std::string capitalised(std::string text) {
  std::replace(text.begin(), text.end(), '-', ' ');
  if (text == "melanopic edi") return "Melanopic EDI";
  if (text.find("illuminance") == std::string::npos) text += " illuminance";
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

void setWords(const Results& results, const GridResult& grid, const Paper& paper, plot::PlanMap& map) {
  map.title = results.project;
  map.legendTitle = capitalised(grid.quantity);
  map.unit = grid.unit;
  map.xTitle = paper.xTitle;
  map.yTitle = paper.yTitle;
  map.subtitle = fmt::format("{} on the grid “{}”", map.legendTitle, grid.name);
  if (paper.isPlan && !grid.points.empty()) {
    const auto [low, high] = std::minmax_element(grid.points.begin(), grid.points.end(),
                                                 [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
    if (high->z - low->z < 1e-6) map.subtitle += fmt::format(", {:.2f} m high", low->z);
  }
  if (!results.lightingScene.empty()) map.subtitle += fmt::format(", lighting scene “{}”", results.lightingScene);

  const auto fact = [&](const char* name, const core::Estimate& estimate, const std::string& unit) {
    const std::string text = plot::uncertaintyText(estimate.value, estimate.halfWidth());
    map.facts.push_back(fmt::format("{} {}{}", name, text, unit.empty() ? "" : " " + unit));
  };
  fact("mean", grid.mean, grid.unit);
  fact("min", grid.min, grid.unit);
  fact("max", grid.max, grid.unit);
  fact("U₀", grid.u0, "");
  if (!results.reached) map.facts.emplace_back("accuracy asked for not reached");

  map.footer =
      fmt::format("goniolux {} · half-widths at {:g} % confidence · seed {} · project {}", results.programVersion,
                  100 * results.confidence, results.seed, results.projectHash.substr(0, 12));
}

void setScale(const GridResult& grid, const MapOptions& options, plot::PlanMap& map) {
  std::vector<double> values, halfWidths;
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    if (std::isnan(grid.values[i])) continue;
    values.push_back(grid.values[i]);
    halfWidths.push_back(grid.halfWidths[i]);
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto middle = halfWidths.begin() + std::ssize(halfWidths) / 2;
  std::nth_element(halfWidths.begin(), middle, halfWidths.end());
  map.lowest = *low;
  map.highest = *high;
  // Lines closer than twice the typical half-width would draw noise.
  const double finest = 2 * *middle;
  map.levels = options.levels.empty() ? plot::mapLevels(values, finest) : options.levels;
  if (map.levels.empty() && map.highest - map.lowest < std::max(2 * finest, 0.02 * std::abs(map.highest))) {
    // One colour for what is the same everywhere.
    const double span = std::max(0.1 * std::abs(map.highest), 1e-3);
    map.lowest -= span;
    map.highest += span;
  } else if (!(map.highest > map.lowest)) {
    map.highest = map.lowest + std::max(0.1 * std::abs(map.lowest), 1e-3);
  }
  if (map.lowest < 0 && *low >= 0) map.lowest = 0;
}

void setLines(const Outline& outline, const Paper& paper, plot::PlanMap& map) {
  const double tolerance = 1e-5 * std::max(glm::distance(outline.low, outline.high), 1e-3);
  std::vector<std::pair<Vec2, Vec2>> room, objects;
  for (const ObjectOutline& object : outline.objects) {
    for (const Segment& edge : paper.isPlan ? object.plan : object.edges) {
      const bool near = std::abs(paper.above(edge.from)) < inPlane_m && std::abs(paper.above(edge.to)) < inPlane_m;
      if (!paper.isPlan && !near) continue;
      (object.isRoom ? room : objects).emplace_back(paper.onPaper(edge.from), paper.onPaper(edge.to));
    }
  }
  map.roomLines = plot::joined(room, tolerance);
  map.objectLines = plot::joined(objects, tolerance);
  if (!paper.isPlan) return;
  for (const LuminaireOutline& luminaire : outline.luminaires) {
    plot::MapLuminaire symbol{luminaire.name, paper.onPaper(luminaire.position), {}};
    for (const Vec3& corner : luminaire.footprint) symbol.footprint.push_back(paper.onPaper(corner));
    map.luminaires.push_back(std::move(symbol));
  }
}

}  // namespace

plot::PlanMap planMapOf(const Results& results, const GridResult& grid, const Outline* outline,
                        const MapOptions& options) {
  plot::PlanMap map;
  const std::optional<GridPlane> plane = planeOf(grid);
  const Paper paper = paperOf(plane);
  setWords(results, grid, paper, map);
  map.width = options.width;
  map.height = options.height;
  map.palette = options.palette;
  map.banded = options.banded;
  for (const Vec3& point : grid.points) map.points.push_back(paper.onPaper(point));
  map.values = grid.values;
  // A single row of points is no area: it is drawn as dots.
  if (plane && (*grid.counts)[0] > 1 && (*grid.counts)[1] > 1) {
    const Vec2 origin = paper.onPaper(plane->origin);
    map.grid = plot::MapGrid{origin, paper.onPaper(plane->origin + plane->u) - origin,
                             paper.onPaper(plane->origin + plane->v) - origin, (*grid.counts)[0], (*grid.counts)[1]};
  }
  setScale(grid, options, map);
  if (outline) setLines(*outline, paper, map);
  return map;
}

}  // namespace goniolux::pipeline
