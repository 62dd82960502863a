// Interreflection between diffuse surfaces: exact series, and rooms solved by another program.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/progress.h"
#include "pipeline/study_choices.h"
#include "validation/projects.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

using core::pi;
using core::Vec3;

constexpr Vec3 up{0, 0, 1}, down{0, 0, -1};

// A lamp in the middle of a sphere of 1 m; `port` is the share of the sphere that is cut off at the top.
std::vector<Number> sphere(double port, const std::vector<double>& reflectances) {
  std::vector<Number> numbers;
  for (const double rho : reflectances) {
    ProjectText project;
    project.paint("paint", rho);
    if (port == 0)
      project.object(R"("shape": "sphere", "center": [0,0,0], "radius": 1, "facing": "inward", "material": "paint")");
    else
      project.object(fmt::format(R"("shape": "quadric", "xx": 1, "yy": 1, "zz": 1, "constant": -1, "size": 1, )"
                                 R"("min": [-1.1,-1.1,-1.1], "max": [1.1,1.1,{}], "material": "paint")",
                                 1 - 2 * port));
    project.luminaire({0, 0, 0}, R"("photometry": "isotropic", "flux": 1000)");
    project.points("wall", {{0, 0, -1 + 1e-6}, {0.6 - 1e-6, 0, -0.8 + 1e-6}, {1 - 1e-6, 0, 0}},
                   {up, {-0.6, 0, 0.8}, {-1, 0, 0}});
    const auto results = calculate(project, "0.5 %");
    // Every point of a sphere sees each of its zones in proportion to area: indirect light is even.
    const double direct = 1000 / (4 * pi), indirect = direct * rho * (1 - port) / (1 - rho * (1 - port));
    for (std::size_t i = 0; i < 3; ++i)
      numbers.push_back(numberAt(fmt::format("ρ {:g}, point {}", rho, i + 1), direct + indirect, results.grids[0], i));
  }
  return numbers;
}

// In a sphere with its lamp in the middle every path carries the same: what is missing after n reflections is exact.
std::vector<Number> bounceCaps() {
  std::vector<Number> numbers;
  for (const double rho : {.5, .9, .95, .99}) {
    ProjectText project;
    project.paint("paint", rho);
    project.object(R"("shape": "sphere", "center": [0,0,0], "radius": 1, "facing": "inward", "material": "paint")");
    project.luminaire({0, 0, 0}, R"("photometry": "isotropic", "flux": 1000)");
    project.points("wall", {{0, 0, -1 + 1e-6}}, {up});
    core::SilentProgress silent;
    const auto found = pipeline::findChoiceStudy("bounces")->run(projectOf(project), silent);
    for (const std::size_t n : {1, 2, 4, 8, 16, 27, 64}) {
      const double missing = std::pow(rho, static_cast<double>(n));  // of the indirect light
      if (missing < 1e-3) continue;                                  // the study rounds to 1e-4 %
      numbers.push_back({fmt::format("ρ {:g}, {} reflections, of indirect", rho, n), -100 * missing,
                         -std::stod(found.rows.at(n).at(3)), 0});
      numbers.push_back({fmt::format("ρ {:g}, {} reflections, of all", rho, n), -100 * missing * rho,
                         -std::stod(found.rows.at(n).at(2)), 0});
    }
  }
  return numbers;
}

std::vector<Number> planes(const std::vector<std::pair<double, double>>& reflectances) {
  std::vector<Number> numbers;
  for (const auto& [below, above] : reflectances) {
    ProjectText project;
    project.paint("below", below, 100);
    project.paint("above", above);
    const double side = 4000;
    project.rectangle({-side / 2, -side / 2, 0}, {side, 0, 0}, {0, side, 0}, "below");
    project.rectangle({-side / 2, -side / 2, 1}, {side, 0, 0}, {0, side, 0}, "above");
    project.points("points", {{0, 0, 1e-6}, {0, 0, 1 - 1e-6}}, {up, down});
    const auto results = calculate(project, "0.5 %");
    const double onAbove = 100 / (1 - below * above);
    const std::string name = fmt::format("ρ {:g} and {:g}", below, above);
    numbers.push_back(numberAt(name + ", the dark plane", onAbove, results.grids[0], 1));
    numbers.push_back(numberAt(name + ", the bright plane", above * onAbove, results.grids[0], 0));
  }
  return numbers;
}

// A room with things in it, every surface emits 1 and reflects rho: E = 1 / (1 - rho) everywhere.
std::vector<Number> furnace(const std::vector<double>& reflectances) {
  std::vector<Number> numbers;
  for (const double rho : reflectances) {
    ProjectText project;
    project.paint("hot", rho, 1);
    project.room({5, 4, 3}, "hot");
    project.object(R"("shape": "box", "min": [1,1,0], "max": [2,2,0.8], "material": "hot")");
    project.object(R"("shape": "sphere", "center": [3.5,2.5,1.2], "radius": 0.5, "material": "hot")");
    project.object(R"("shape": "torus", "center": [3,1,2], "ring_radius": 0.5, "tube_radius": 0.1, "material": "hot")");
    project.points("points", {{0.5, 0.5, 1e-6}, {1.5, 1.5, 0.9}, {3.5, 2.5, 0.5}, {4.9, 3.9, 2.9}},
                   {up, up, down, {-1, 0, 0}});
    const auto results = calculate(project, "0.5 %");
    const char* names[] = {"floor", "over the box", "under the sphere", "in a corner"};
    for (std::size_t i = 0; i < 4; ++i)
      numbers.push_back(numberAt(fmt::format("ρ {:g}, {}", rho, names[i]), 1 / (1 - rho), results.grids[0], i));
  }
  return numbers;
}

std::vector<Number> unitCube() {
  const struct {
    double rho, floor, ceiling, wall, corner;
  } rows[] = {{.2, .276057, .049338, .231151, .203808},
              {.5, .395210, .183610, .355295, .308107},
              {.8, .891355, .690326, .854580, .782113},
              {.9, 1.72390, 1.52527, 1.68771, 1.60452}};
  std::vector<Number> numbers;
  for (const auto& row : rows) {
    ProjectText project;
    project.paint("wall", row.rho);
    project.paint("ceiling", row.rho, 1000);
    project.object(R"("shape": "box", "min": [0,0,0], "max": [1,1,1], "facing": "inward", )"
                   R"("materials": { "ceiling": "ceiling", "*": "wall" })");
    project.points("points", {{.5, .5, 1e-6}, {.5, .5, 1 - 1e-6}, {.5, 1e-6, .5}, {.125, .125, 1e-6}},
                   {up, down, {0, 1, 0}, up});
    const auto results = calculate(project, "0.5 %");
    const double expected[] = {row.floor, row.ceiling, row.wall, row.corner};
    const char* names[] = {"middle of the floor", "middle of the ceiling", "middle of a wall", "floor at (1/8, 1/8)"};
    for (std::size_t i = 0; i < 4; ++i)
      numbers.push_back(numberAt(fmt::format("ρ {:g}, {}", row.rho, names[i]), 1000 * expected[i], results.grids[0], i,
                                 0.3 * expected[i]));
  }
  return numbers;
}

}  // namespace

Section interreflectionSection() {
  Section section;
  section.title = "Interreflection";
  section.introduction = "Exact answers: no cap on the number of reflections can hide here.";
  section.cases = {
      {"3.1", "Sphere", "lx", "radius 1 m, 1000 lm in the middle; three points", "E = Φ / (4π R² (1 − ρ))", "", 7e-3, 0,
       false,
       [] {
         return sphere(0, {.5, .9});
       }},
      {"3.1x", "White sphere", "lx", "the same", "E = Φ / (4π R² (1 − ρ))", "", 7e-3, 0, true,
       [] {
         return sphere(0, {.95, .99});
       }},
      {"3.1p", "Sphere with a port", "lx", "the same, 2 % of the sphere cut off",
       "E = E₀ (1 + ρ (1 − f) / (1 − ρ (1 − f)))", "", 7e-3, 0, false,
       [] {
         return sphere(0.02, {.5, .9});
       }},
      {"3.1q", "White sphere with a port", "lx", "the same", "E = E₀ (1 + ρ (1 − f) / (1 − ρ (1 − f)))", "", 7e-3, 0,
       true,
       [] {
         return sphere(0.02, {.95, .99});
       }},
      {"3.2", "Two endless planes", "lx", "4 km × 4 km, 1 m apart; one emits 100 lm/m²",
       "E₂ = M / (1 − ρ₁ρ₂), E₁ = ρ₂ E₂", "", 7e-3, 0, false,
       [] {
         return planes({{.5, .5}, {.8, .2}, {.9, .9}});
       }},
      {"3.2x", "Two endless white planes", "lx", "the same", "E₂ = M / (1 − ρ₁ρ₂), E₁ = ρ₂ E₂", "", 7e-3, 0, true,
       [] {
         return planes({{.95, .99}});
       }},
      {"3.3", "Furnace", "lx", "a furnished room in which every surface emits 1 lm/m² and reflects ρ",
       "E = M / (1 − ρ)", "", 7e-3, 0, false,
       [] {
         return furnace({.5, .8, .9});
       }},
      {"3.3x", "White furnace", "lx", "the same", "E = M / (1 − ρ)", "", 7e-3, 0, true,
       [] {
         return furnace({.95, .99});
       }},
      {"3.4", "Unit cube under a bright ceiling", "lx", "the ceiling emits 1000 lm/m², every face reflects ρ",
       "integral equation by Nyström's method, extrapolated (3·10⁻⁴); calculated by another program",
       "radiosity with one patch a face: up to 18 % off", 7e-3, 0, false, unitCube},
      {"3.7", "Paths that end after n reflections", "%",
       "the sphere of 3.1, light that is missing (`goniolux study --of bounces`)",
       "−ρⁿ of indirect, −ρⁿ⁺¹ of all light", "27 reflections explain Radiance's −5.8 % and −25 % in 5.8", 1e-3, 0,
       false, bounceCaps},
  };
  return section;
}

}  // namespace goniolux::validation
