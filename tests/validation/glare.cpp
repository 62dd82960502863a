// Glare ratings and the hand method of the lumen calculation.
#include <fmt/format.h>

#include <cmath>

#include "analysis/position_index.h"
#include "analysis/ugr_table.h"
#include "analysis/utilisation.h"
#include "photometry/intensity_distribution.h"
#include "validation/projects.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

using namespace analysis;
using core::pi;
using core::Vec3;
using photometry::CosinePowerDistribution;

// One Lambertian luminaire 0.6 x 0.6 m of 5000 cd/m2, 1.8 m above the eye, R ahead and T aside, L_b 40 cd/m2: the
// formula with Guth's index by Levin's, written out.
std::vector<Number> singleLuminaire() {
  const CosinePowerDistribution cosine(5000 * 0.36, 1);
  const GlareSource source{&cosine, {0.6, 0.6, 0}, false};
  const struct {
    double r, t, ugr;
  } rows[] = {{2, 0, 17.2399}, {4, 0, 18.0556}, {6, 0, 16.5685}, {4, 2, 16.8018}, {8, 4, 12.6828}};
  std::vector<Number> numbers;
  for (const auto& row : rows)
    numbers.push_back({fmt::format("R {:g} m, T {:g} m", row.r, row.t), row.ugr,
                       ugr(glareSum(source, {1, 1, row.t, row.r, 1, 1.8, {1, 0, 0}}, false), 40), 0});
  const double one = ugr(glareSum(source, {1, 1, 0, 4, 1, 1.8, {1, 0, 0}}, false), 40);
  const CosinePowerDistribution twice(2 * 5000 * 0.36, 1);
  const GlareSource brighter{&twice, {0.6, 0.6, 0}, false};
  const double sum = glareSum(brighter, {1, 1, 0, 4, 1, 1.8, {1, 0, 0}}, false);
  numbers.push_back({"twice the luminance: rise", 16 * std::log10(2.0), ugr(sum, 40) - one, 0});
  numbers.push_back({"twice all light: rise", 8 * std::log10(2.0), ugr(sum, 80) - one, 0});
  return numbers;
}

std::vector<Number> positionIndices() {
  const struct {
    double t, h, p;
  } rows[] = {{0, 0.1, 1.2225}, {0, 0.5, 2.86016}, {0, 1, 7.05933}, {0, 1.5, 13.1877}, {0.5, 0, 1.37832},
              {1, 0, 2.050},    {1, 1, 7.030},     {2, 0, 3.516},   {2, 1, 8.295}};
  std::vector<Number> numbers;
  for (const auto& row : rows)
    numbers.push_back({fmt::format("T/R {:g}, H/R {:g}", row.t, row.h), row.p,
                       positionIndex({0, 1, 0}, {0, 0, 1}, glm::normalize(Vec3(row.t, 1, row.h))), 0});
  return numbers;
}

// 8 x 16 x 3.2 m, 32 recessed Lambertian panels of 1000 lm, the eye at the middle of a wall, 1.2 m high.
std::vector<Number> room() {
  ProjectText project;
  project.paint("ceiling", 0.7);
  project.paint("walls", 0.5);
  project.paint("floor", 0.2);
  project.object(R"("shape": "box", "min": [0,0,0], "max": [8,16,3.2], "facing": "inward", )"
                 R"("materials": { "ceiling": "ceiling", "walls": "walls", "floor": "floor" })");
  project.luminaire({1, 1, 3.2}, R"("photometry": "cosine", "flux": 1000, "reflectance": 0.7, )"
                                 R"("shape": { "rectangle": { "length": 0.6, "width": 0.6 } }, )"
                                 R"("array": { "counts": [4,8], "u": [2,0,0], "v": [0,2,0] })");
  project.points("any", {{4, 8, 0.8}}, {{0, 0, 1}});
  project.observer("endwise", {4, 1e-3, 1.2}, {0, 1, 0});
  project.observer("crosswise", {1e-3, 8, 1.2}, {1, 0, 0});
  const auto results = calculate(project, "2 %");
  return {numberOf("UGR from the 8 m wall", 17.323, results.observers.at(0).value, 0.02),
          numberOf("UGR from the 16 m wall", 16.495, results.observers.at(1).value, 0.02),
          numberOf("background / (cd/m²), from the 8 m wall", 44.652 / pi, results.observers.at(0).background,
                   0.002 * 44.652 / pi),
          numberOf("background / (cd/m²), from the 16 m wall", 45.121 / pi, results.observers.at(1).background,
                   0.002 * 45.121 / pi)};
}

// The glare sum alone, with the other program's background.
std::vector<Number> roomSums() {
  const CosinePowerDistribution cosine(1000 / pi, 1);
  const GlareSource source{&cosine, {0.6, 0.6, 0}, false};
  const GlareGrid endwise{4, 8, -3, 1, 2, 2, {1, 0, 0}}, crosswise{8, 4, -7, 1, 2, 2, {1, 0, 0}};
  return {{"endwise, within the field", 17.323, ugr(glareSum(source, endwise, true), 44.6518 / pi), 0},
          {"endwise, all luminaires", 17.455, ugr(glareSum(source, endwise, false), 44.6518 / pi), 0},
          {"crosswise, within the field", 16.4948, ugr(glareSum(source, crosswise, true), 45.1206 / pi), 0},
          {"crosswise, all luminaires", 16.6837, ugr(glareSum(source, crosswise, false), 45.1206 / pi), 0}};
}

std::vector<Number> zonalCavity() {
  const Cavity cavity{3, 2};  // 6 m x 4 m, 2 m high
  return {{"form factor floor to ceiling, 6 × 4 × 2", 0.475576, floorToCeiling(cavity), 0},
          {"form factor of a cube", 0.199824896, floorToCeiling({1, 1}), 0},
          {"utilisation of room A", 0.692967,
           utilisationFactor(0, 1000, 1000, 0.520512, cavity, {0.646863, 0.5, 0.186589}), 0}};
}

/// What a cavity of proportion 1.6 : 1 sends back through its opening, by three-surface exchange. `ratio`: the cavity
/// ratio, 5 h (L + W) / (L W).
double effectiveReflectance(double base, double walls, const Cavity& cavity) {
  const double f = floorToCeiling(cavity), wallArea = 2 * (1 / cavity.length + 1 / cavity.width);
  return exchange({f, 1 - f, 0}, f, wallArea, {base, walls, 0}).floor;
}
Cavity cavityOf(double ratio) {
  const double width = 2.6 / 1.6 * 5 / ratio;
  return {1.6 * width, width};
}

std::vector<Number> cavities(bool asPrinted) {
  const struct {
    double base, walls, ratio, exact, printed;  // %
  } rows[] = {{.8, .5, .2, 76.9343, 77}, {.8, .5, 1, 66.1426, 67}, {.8, .5, 2, 55.3037, 56}, {.8, .5, 3, 46.7812, 47},
              {.7, .5, 1, 58.1529, 58},  {.5, .5, 2, 36.4703, 37}, {.3, .1, 1, 21.6869, 22}, {.1, .5, 1, 11.5713, 12},
              {.9, .9, 1, 86.6037, 86},  {.8, .3, 3, 37.6474, 37}};
  std::vector<Number> numbers;
  for (const auto& row : rows)
    numbers.push_back({fmt::format("base {:g} %, walls {:g} %, ratio {:g}", 100 * row.base, 100 * row.walls, row.ratio),
                       asPrinted ? row.printed : row.exact,
                       100 * effectiveReflectance(row.base, row.walls, cavityOf(row.ratio)), 0});
  return numbers;
}

// Room A by the hand method, every step by ours: cavities above the lamps (2.8 m) and below the work plane (0.8 m),
// direct light on the work plane, utilisation, mean.
std::vector<Number> roomAByHand() {
  const double ceiling = effectiveReflectance(.7, .5, {6 / .2, 4 / .2}),
               floor = effectiveReflectance(.2, .5, {6 / .8, 4 / .8}), flux = 4 * pi * 1000;
  ProjectText project;
  project.paint("black", 0);
  project.room({6, 4, 3}, "black");
  for (const double x : {1.5, 4.5})
    for (const double y : {1.0, 3.0})
      project.luminaire({x, y, 2.8}, fmt::format(R"("photometry": "cosine", "flux": {})", 1000 * pi));
  project.plane("work plane", {0, 0, 0.8}, {6, 0, 0}, {0, 4, 0}, 120, 80, {0, 0, 1});
  const double direct = calculate(project, "0.5 %").grids[0].mean.value * 24 / flux;
  const double utilisation = utilisationFactor(0, flux, flux, direct, {3, 2}, {ceiling, .5, floor});
  return {{"ceiling cavity", .646863, ceiling, 0},
          {"floor cavity", .186589, floor, 0},
          {"direct ratio", .520512, direct, 0},
          {"coefficient of utilisation", .692967, utilisation, 0},
          {"mean / lx", 362.836, utilisation * flux / 24, 0}};
}

}  // namespace

Section glareSection() {
  Section section;
  section.title = "Glare and the hand method";
  section.introduction =
      "UGR of CIE 117 with Guth's index by Levin's formula, which CIE 117 tabulates: the table is coarser (1.26 where "
      "the "
      "formula gives 1.22). The worked example of CIE 190 is not public.";
  section.cases = {
      {"6.1", "One luminaire", "UGR", "0.6 m × 0.6 m, 5000 cd/m², 1.8 m above the eye, background 40 cd/m²",
       "the formula, evaluated by another program", "", 1e-3, 0, false, singleLuminaire},
      {"6.2", "Position index", "", "H above and T beside the line of sight at distance R",
       "Levin's formula, evaluated by another program", "", 2e-4, 0, false, positionIndices},
      {"6.3", "A room 4H × 8H", "", "32 panels of 1000 lm, reflectances 0.7 / 0.5 / 0.2; observers of a project",
       "radiosity and the formula, by another program (0.02)", "", 4e-2, 0, false, room},
      {"6.3s", "Glare sum of the same room", "UGR", "without the room's own background",
       "the formula, by another program", "", 1e-3, 0, false, roomSums},
      {"6.5", "Zonal cavity", "",
       "form factors, and the utilisation of room A by hand (the exact mean is 0.9 % higher)",
       "three-surface exchange, by another program", "", 1e-5, 0, false, zonalCavity},
      {"6.5c", "Effective cavity reflectance", "%", "cavities of 1.6 : 1", "three-surface exchange, by another program",
       "", 1e-5, 0, false, [] { return cavities(false); }},
      {"6.5t", "Effective cavity reflectance, printed", "%", "the same", "table of the IES, to the whole percent (± 1)",
       "", 1e-2, 100, false, [] { return cavities(true); }},
      {"6.6", "Room A by hand", "", "zonal-cavity method from the reflectances to the mean",
       "the same method, by another program; the exact mean is 366.25 lx", "", 5e-4, 0, false, roomAByHand},
  };
  return section;
}

}  // namespace goniolux::validation
