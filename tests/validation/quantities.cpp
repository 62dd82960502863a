// Quantities beside planar illuminance, under a point source and in a uniform surround.
#include <fmt/format.h>

#include <cmath>

#include "validation/projects.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

using core::pi;
using core::Vec3;

// 250 lx on a plane that faces the source, at an elevation and at an azimuth from the direction that a half cylinder
// faces.
std::vector<Number> underPointSource() {
  const struct {
    const char* quantity;
    double elevation, azimuth;
    double (*closed)(double e, double a);
  } rows[] = {
      {"cylindrical", 0, 20, [](double e, double) { return 250 * std::cos(e) / pi; }},
      {"cylindrical", 30, 200, [](double e, double) { return 250 * std::cos(e) / pi; }},
      {"cylindrical", 60, 77, [](double e, double) { return 250 * std::cos(e) / pi; }},
      {"semi-cylindrical", 30, 0, [](double e, double a) { return 250 * std::cos(e) * (1 + std::cos(a)) / pi; }},
      {"semi-cylindrical", 30, 60, [](double e, double a) { return 250 * std::cos(e) * (1 + std::cos(a)) / pi; }},
      {"semi-cylindrical", 30, 120, [](double e, double a) { return 250 * std::cos(e) * (1 + std::cos(a)) / pi; }},
      {"semi-cylindrical", 30, 180, [](double e, double a) { return 250 * std::cos(e) * (1 + std::cos(a)) / pi; }},
      {"hemispherical", 0, 0, [](double e, double) { return 250 * (1 + std::sin(e)) / 4; }},
      {"hemispherical", 30, 45, [](double e, double) { return 250 * (1 + std::sin(e)) / 4; }},
      {"hemispherical", -30, 45, [](double e, double) { return 250 * (1 + std::sin(e)) / 4; }},
      {"hemispherical", 60, 0, [](double e, double) { return 250 * (1 + std::sin(e)) / 4; }},
      {"spherical", -75, 10, [](double, double) { return 62.5; }},
      {"spherical", 30, 0, [](double, double) { return 62.5; }},
  };
  std::vector<Number> numbers;
  for (const auto& row : rows) {
    const double e = row.elevation * core::degree, a = row.azimuth * core::degree;
    ProjectText project;
    project.paint("black", 0);
    project.room({20, 20, 20}, "black", {-10, -10, -10});
    project.luminaire(2.0 * Vec3(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)),
                      fmt::format(R"("photometry": "isotropic", "flux": {})", 4000 * pi));
    const Vec3 normal = std::string(row.quantity) == "semi-cylindrical" ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
    project.points("point", {{0, 0, 0}}, {normal}, fmt::format(R"("quantity": "{}")", row.quantity));
    const auto results = calculate(project, "0.1 %");
    numbers.push_back(
        numberAt(fmt::format("{}, elevation {:g}°, azimuth {:g}°", row.quantity, row.elevation, row.azimuth),
                 row.closed(e, a), results.grids[0], 0));
  }
  return numbers;
}

// A room whose walls all emit 100 lm/m2 and reflect a half: exitance 200 everywhere, which is every quantity as well.
std::vector<Number> inUniformSurround() {
  std::vector<Number> numbers;
  ProjectText project;
  project.paint("bright", 0.5, 100);
  project.room({3, 4, 2.5}, "bright");
  const char* quantities[] = {"illuminance", "cylindrical", "semi-cylindrical", "hemispherical", "spherical"};
  for (const char* quantity : quantities)
    project.points(quantity, {{1, 1.5, 1}}, {{1, 0, 0}}, fmt::format(R"("quantity": "{}")", quantity));
  const auto results = calculate(project, "0.5 %");
  for (std::size_t i = 0; i < 5; ++i) numbers.push_back(numberAt(quantities[i], 200, results.grids[i], 0));
  return numbers;
}

}  // namespace

Section quantitySection() {
  Section section;
  section.title = "Photometric quantities";
  section.introduction = "Cylindrical, semi-cylindrical, hemispherical and spherical illuminance (CIE S 017).";
  section.cases = {
      {"2.8", "Point source", "lx", "250 lx on a facing plane; elevation and azimuth of the source",
       "E cos ε / π, E cos ε (1 + cos α) / π, E (1 + sin ε) / 4, E / 4", "", 2e-3, 50, false, underPointSource},
      {"2.8u", "Uniform surround", "lx", "every wall emits 100 lm/m² and reflects 0.5",
       "π L for every quantity: M / (1 − ρ)", "", 5e-3, 0, false, inUniformSurround},
  };
  return section;
}

}  // namespace goniolux::validation
