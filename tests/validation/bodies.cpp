// Light through bodies of glass and water, along one ray: by the intersection tree, whose depth is known.
#include <fmt/format.h>

#include <cmath>

#include "geometry/objects.h"
#include "reflection/fresnel.h"
#include "solver/intersection_tree.h"
#include "solver/tree_shadings.h"
#include "support/mirror_scenes.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

using core::Vec3;

class Bodies {
 public:
  Bodies() { environment_.sourceSpectra = {spectrum::SpectralDistribution::flat(1)}; }

  void box(const Vec3& min, const Vec3& max, double index) {
    add(geometry::findObjectType("box")->make({{"min", min}, {"max", max}}), index);
  }
  /// A body of triangles, counter-clockwise seen from outside.
  void body(std::vector<Vec3> vertices, std::vector<std::array<std::uint32_t, 3>> triangles, double index) {
    geometry::Shape shape;
    shape.partNames = {"surface"};
    shape.mesh.vertices = std::move(vertices);
    shape.mesh.triangles = std::move(triangles);
    shape.mesh.parts.assign(shape.mesh.triangles.size(), 0);
    shape.closed = true;
    add(std::move(shape), index);
  }
  /// A luminous ball of 1 cd/m2.
  void lamp(const Vec3& center, double radius) { test::addBall(environment_, center, radius, 1); }

  /// Luminance that the ray sees, and the nodes of its tree.
  struct Seen {
    double luminance = 0, nodes = 0;
  };
  [[nodiscard]] Seen seen(const Vec3& eye, const Vec3& direction, const solver::TreeControl& control) const {
    const scene::World world = scene::buildWorld(environment_);
    const tracer::Tracer tracer(world);
    const auto quadrature = spectrum::flatQuadrature(world.sourceSpectra);
    const solver::Shadings shadings = solver::makeShadings(world, quadrature, {});
    const solver::TreeLighting lighting = solver::treeLighting(world, quadrature, {});
    const solver::TreeBuilder builder(world, tracer, shadings, 1, 0, control, {1, 1, 1});
    solver::IntersectionTree tree;
    core::Sampler random(1, 0);
    builder.build(eye - world.origin, glm::normalize(direction), random, tree);
    return {solver::evaluate(tree, shadings, lighting, world)[1], static_cast<double>(tree.nodes.size())};
  }

 private:
  void add(geometry::Shape shape, double index) {
    scene::Object object;
    object.shape = std::move(shape);
    object.materials.assign(object.shape.partNames.size(), static_cast<std::uint32_t>(environment_.materials.size()));
    environment_.materials.push_back(test::flatFinish("dielectric", "ior", index));
    environment_.objects.push_back(std::move(object));
  }
  scene::Environment environment_;
};

/// Transmittance at normal incidence through a row of media, all reflections between the interfaces added up.
double through(const std::vector<double>& indices) {
  double onward = 1, back = 0;  // of the interfaces so far
  for (std::size_t i = 0; i + 1 < indices.size(); ++i) {
    const double r = std::pow((indices[i] - indices[i + 1]) / (indices[i] + indices[i + 1]), 2);
    const double again = 1 / (1 - back * r);
    back = back + onward * onward * r * again;
    onward *= (1 - r) * again;
  }
  return onward;
}

// A box of water and one of glass on it, 0.1 mm into each other or 1 mm apart, looked through upwards.
std::vector<Number> overlap() {
  std::vector<Number> numbers{
      {"interface, from water", .00360849, reflection::dielectricReflectance(1, 1.5 / 1.33).mean(), 0},
      {"interface, from glass", .00360849, reflection::dielectricReflectance(1, 1.33 / 1.5).mean(), 0}};
  const struct {
    const char* what;
    double bottom;  // of the glass; the water ends at 0.1
    bool waterFirst;
    std::vector<double> indices;
  } rows[] = {{"seen through both, water named first", .0999, true, {1, 1.33, 1.5, 1}},
              {"seen through both, glass named first", .0999, false, {1, 1.33, 1.5, 1}},
              {"with a gap of air", .101, true, {1, 1.33, 1, 1.5, 1}}};
  for (const auto& row : rows) {
    Bodies bodies;
    for (const bool water : {row.waterFirst, !row.waterFirst}) {
      if (water) bodies.box({-1, -1, 0}, {1, 1, .1}, 1.33);
      if (!water) bodies.box({-1, -1, row.bottom}, {1, 1, .2}, 1.5);
    }
    bodies.lamp({0, 0, 1}, .2);
    numbers.push_back(
        {row.what, through(row.indices), bodies.seen({0, 0, -1}, {0, 0, 1}, {60, 1e-8, true}).luminance, 0});
  }
  return numbers;
}

// A right-angled prism turns the ray by 90 degrees: 45 degrees inside are beyond the critical angle of 41.8.
std::vector<Number> prism() {
  Bodies bodies;
  bodies.body({{0, -1, 0}, {1, -1, 0}, {0, -1, 1}, {0, 1, 0}, {1, 1, 0}, {0, 1, 1}},
              {{0, 1, 2}, {3, 5, 4}, {0, 2, 5}, {0, 5, 3}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}}, 1.5);
  bodies.lamp({.7, 0, -1}, .2);
  const Vec3 eye{-1, 0, .3}, ahead{1, 0, 0};
  return {{"one pass", .9216, bodies.seen(eye, ahead, {4, 0, true}).luminance, 0},
          {"with what the faces throw back", 12.0 / 13, bodies.seen(eye, ahead, {60, 1e-7, true}).luminance, 0}};
}

// A rod of 10 mm and 1 m: the ray enters one end at an angle and leaves the other after many total reflections.
std::vector<Number> lightGuide(const std::vector<std::pair<double, double>>& rows) {
  Bodies rod;
  rod.box({0, -.005, -.005}, {1, .005, .005}, 1.5);
  rod.lamp({11, 0, 0}, 9.98);  // whatever leaves the end meets it, 20 mm away or more
  std::vector<Number> numbers;
  for (const auto& [degrees, transmittance] : rows) {
    const double a = degrees * core::degree;
    const Vec3 ahead{std::cos(a), 0, std::sin(a)};
    numbers.push_back({fmt::format("{:g}°", degrees), transmittance,
                       rod.seen(Vec3(-1e-4, .0003, .0007) - ahead * .01, ahead, {2000, 1e-6, true}).luminance, 0});
  }
  return numbers;
}

// Forty panes in a row and the eye among them: no ray gets out within 15 surfaces, and each spawns two.
std::vector<Number> binaryTrees() {
  Bodies panes;
  for (int i = -20; i < 20; ++i) panes.box({-9, -9, i + .25}, {9, 9, i + .75}, 1.5);
  std::vector<Number> numbers;
  for (const int depth : {1, 5, 10, 15})
    numbers.push_back({fmt::format("depth {}", depth), std::pow(2.0, depth) - 1,
                       panes.seen({0, 0, 0}, {0, 0, 1}, {depth, 0, false}).nodes, 0});
  return numbers;
}

}  // namespace

Section bodySection() {
  Section section;
  section.title = "Bodies of glass and water";
  section.introduction = "What one ray sees through them: a luminous ball of 1 cd/m², by the solver `tree`.";
  section.cases = {
      {"4.6", "Glass that overlaps water", "", "index 1.5 and 1.33, normal incidence",
       "((n₁ − n₂) / (n₁ + n₂))², and the series of reflections between the interfaces",
       "an air gap between them reflects 0.0585, 16 times as much", 1e-5, 0.3, false, overlap},
      {"4.7", "Prism 45°-90°-45°", "", "index 1.5; the long side reflects totally",
       "0.96²; with the light that goes to and fro 12/13", "", 1e-5, 0, false, prism},
      {"4.7g", "Light guide", "", "rod of 10 mm × 10 mm × 1 m, index 1.5, up to 54 total reflections; angle outside",
       "(1 − R)/(1 + R) of each polarisation; our rays carry none and take the mean R (0.5 %)",
       "black where depth is limited", 5e-3, 0, false,
       [] {
         return lightGuide({{0, .923077}, {10, .923053}, {45, .907344}});
       }},
      {"4.7h", "Light guide, grazing", "", "the same at 80°, where the mean of both polarisations tells: 1.7 points",
       "(1 − R)/(1 + R) of each polarisation", "", 2e-2, 1, false,
       [] {
         return lightGuide({{80, .458473}});
       }},
      {"7.4", "Forced trees in glass", "nodes", "forty panes in a row: every surface spawns two rays", "2^D − 1", "",
       1e-9, 0, false, binaryTrees},
  };
  return section;
}

}  // namespace goniolux::validation
