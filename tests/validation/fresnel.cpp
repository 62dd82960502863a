// Fresnel reflection, panes, metals, and the paper's terms; no chance is involved.
#include <fmt/format.h>

#include <cmath>

#include "reflection/fresnel.h"
#include "validation/projects.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

using namespace reflection;

double cosine(double degrees) {
  return std::cos(degrees * core::degree);
}

std::vector<Number> airToGlass() {
  const struct {
    double angle, r;
  } rows[] = {{0, .04},      {30, .0415226}, {45, .0502399}, {56.309932, .0739645}, {60, .0891867},
              {70, .171043}, {75, .253061},  {80, .387704},  {85, .612800},         {89, .904185}};
  std::vector<Number> numbers;
  for (const auto& row : rows)
    numbers.push_back(
        {fmt::format("{:g}°", row.angle), row.r, dielectricReflectance(cosine(row.angle), 1.5).mean(), 0});
  numbers.push_back({"30°, perpendicular", .057796, dielectricReflectance(cosine(30), 1.5).s, 0});
  numbers.push_back({"30°, parallel", .025249, dielectricReflectance(cosine(30), 1.5).p, 0});
  numbers.push_back({"Brewster's angle, parallel", 0, dielectricReflectance(std::cos(std::atan(1.5)), 1.5).p, 0});
  return numbers;
}

// Walsh's closed form of the reflectance of diffuse light (J. W. T. Walsh 1926; in Judd, J. Res. NBS 29, 1942).
double walsh(double n) {
  const double n2 = n * n, n4 = n2 * n2;
  return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
         n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
         2 * n2 * n * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
         8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
}

std::vector<Number> diffuseLight() {
  std::vector<Number> numbers;
  for (const double n : {1.33, 1.5, 1.8}) {
    numbers.push_back({fmt::format("index {:g}, from air", n), walsh(n), diffuseDielectricReflectance(n), 0});
    numbers.push_back({fmt::format("index {:g}, from inside", n), 1 - (1 - walsh(n)) / (n * n),
                       diffuseDielectricReflectance(1 / n), 0});
  }
  return numbers;
}

std::vector<Number> glassToAir() {
  const struct {
    double angle, r;
  } rows[] = {{20, .0417285},  {33.690068, .0739645}, {40, .245291}, {41, .379751}, {41.5, .541620},
              {41.8, .890772}, {41.8104, 1},          {45, 1},       {89.9, 1}};
  std::vector<Number> numbers;
  for (const auto& row : rows)
    numbers.push_back(
        {fmt::format("{:g}°", row.angle), row.r, dielectricReflectance(cosine(row.angle), 1 / 1.5).mean(), 0});
  return numbers;
}

std::vector<Number> metals() {
  const struct {
    const char* name;
    double n, k, r0, r60, r85;
  } rows[] = {{"Al 450 nm", .617953, 5.469, .9240, .9116, .9145}, {"Al 550 nm", .959, 6.687, .9210, .9068, .8845},
              {"Al 610 nm", 1.248, 7.368, .9159, .9004, .8622},   {"Al 650 nm", 1.475, 7.794, .9118, .8953, .8463},
              {"Au 450 nm", 1.508, 1.879, .3857, .4170, .7494},   {"Au 550 nm", .350, 2.714, .8475, .8433, .9357},
              {"Au 610 nm", .206, 3.030, .9225, .9173, .9627},    {"Au 650 nm", .168, 3.138, .9401, .9354, .9697},
              {"Cu 450 nm", 1.166, 2.394, .5525, .5620, .8064},   {"Cu 550 nm", .958, 2.577, .6341, .6360, .8385},
              {"Cu 610 nm", .324, 3.090, .8853, .8779, .9427},    {"Cu 650 nm", .217, 3.638, .9411, .9346, .9631}};
  std::vector<Number> numbers;
  for (const auto& row : rows)
    for (const auto& [angle, r] : std::vector<std::pair<double, double>>{{0, row.r0}, {60, row.r60}, {85, row.r85}})
      numbers.push_back(
          {fmt::format("{}, {:g}°", row.name, angle), r, conductorReflectance(cosine(angle), row.n, row.k).mean(), 0});
  return numbers;
}

std::vector<Number> slabs() {
  const struct {
    double attenuation, angle, r, t;
  } rows[] = {{0, 0, .081682, .918318},   {0, 30, .0840427, .915957},  {0, 45, .0974717, .902528},
              {0, 60, .156529, .843471},  {0, 75, .385195, .614805},   {0, 85, .754354, .245646},
              {7, 0, .0785263, .880419},  {7, 60, .150114, .800342},   {7, 85, .731678, .219149},
              {50, 0, .064022, .679750},  {50, 30, .0652522, .665980}, {50, 60, .122804, .581263},
              {50, 75, .311827, .401330}, {50, 85, .662332, .127999}};
  std::vector<Number> numbers;
  for (const auto& row : rows) {
    const Slab pane = slab(cosine(row.angle), 1.52, row.attenuation, 0.006);
    const std::string name = fmt::format("{:g} /m, {:g}°", row.attenuation, row.angle);
    numbers.push_back({name + ": reflected", row.r, pane.reflectance, 0});
    numbers.push_back({name + ": transmitted", row.t, pane.transmittance, 0});
  }
  numbers.push_back({"index 1.5, normal: transmitted", 12.0 / 13, slab(1, 1.5, 0, 0.001).transmittance, 0});
  return numbers;
}

// A lamp behind a pane, straight and at 45 degrees, and its image in the pane.
std::vector<Number> lampBehindPane() {
  ProjectText project;
  project.material("pane", R"("model": "dielectric", "ior": 1.5, "thickness_m": 0.004)");
  project.surround(30);
  project.rectangle({-20, -20, 1}, {40, 0, 0}, {0, 40, 0}, "pane");
  project.luminaire({0, 0, 2}, fmt::format(R"("photometry": "isotropic", "flux": {})", 4000 * core::pi));
  project.points("points", {{0, 0, 0}, {0, 0, 3}}, {{0, 0, 1}, {0, 0, -1}});
  const auto results = calculate(project, "0.2 %");
  return {numberAt("through it", 250 * 12.0 / 13, results.grids[0], 0),
          numberAt("before it, with the lamp's image", 1000 + 1000.0 / 9 / 13, results.grids[0], 1)};
}

}  // namespace

Section fresnelSection() {
  Section section;
  section.title = "Glass and metal";
  section.introduction = "Unpolarised light on smooth interfaces, and panes with all reflections inside them.";
  const std::string closed = "Fresnel's equations, evaluated by another program";
  section.cases = {
      {"4.1", "Air to glass, index 1.5", "", "reflectance by angle of incidence", closed,
       "Schlick's approximation: −22 % at 60°, +6 % at 85°", 2e-5, 0.05, false, airToGlass},
      {"4.1d", "Diffuse light on glass", "", "hemispherical reflectance",
       "Walsh's closed form; from inside 1 − (1 − R) / n²", "", 1e-4, 0, false, diffuseLight},
      {"4.2", "Glass to air", "", "reflectance by angle of incidence; total from 41.8103° on", closed, "", 2e-5, 0.05,
       false, glassToAir},
      {"4.3", "Metals", "", "n and k of aluminium, gold and copper, rounded to three digits", closed, "", 4e-4, 1,
       false, metals},
      {"4.4", "Pane of 6 mm, index 1.52", "", "reflectance and transmittance with absorption",
       "series of all reflections, polarisations apart; evaluated by another program",
       "polarisations averaged first: 1.3 points wrong at 60°, 2.3 at 75°", 1e-5, 0, false, slabs},
      {"4.4s", "Lamp behind a pane", "lx", "1000 cd, pane of index 1.5 half way to the point",
       "I/d² · 12/13, and I/9 · 1/13 more before it", "0 lx where shadow rays end at glass (several path tracers)",
       1e-3, 0, false, lampBehindPane},
  };
  return section;
}

}  // namespace goniolux::validation
