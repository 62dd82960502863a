// Light by mirrors, flat and curved, and through water.
#include <fmt/format.h>

#include <cmath>

#include "validation/projects.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

using core::pi;

constexpr core::Vec3 up{0, 0, 1};

std::string candela(double cd) {
  return fmt::format(R"("photometry": "isotropic", "flux": {})", 4 * pi * cd);
}

// Mirror x = 0 from 0.5 to 1.5 m height; 1000 cd 1 m before it, 2 m high.
std::vector<Number> mirrorWall() {
  ProjectText project;
  project.material("mirror", R"("model": "mirror", "reflectance": 0.9)");
  project.surround(60);
  project.rectangle({0, -50, 0.5}, {0, 100, 0}, {0, 0, 1}, "mirror");
  project.luminaire({1, 0, 2}, candela(1000));
  const double places[] = {.2, .5, 1, 2, 4};
  std::vector<core::Vec3> points;
  for (const double x : places) points.push_back({x, 0, 0});
  project.points("floor", points, {up});
  const auto results = calculate(project, "0.2 %");
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < 5; ++i) {
    const double x = places[i];
    double lx = 1000 * 2 / std::pow(4 + (x - 1) * (x - 1), 1.5);
    // The image stands at (-1, 2); its ray passes the mirror's plane at this height.
    const double height = 2 * x / (x + 1);
    if (height > 0.5 && height < 1.5) lx += 0.9 * 1000 * 2 / std::pow(4 + (x + 1) * (x + 1), 1.5);
    numbers.push_back(numberAt(fmt::format("x {:g} m", x), lx, results.grids[0], i));
  }
  return numbers;
}

// Mirrors 2 m apart, the source 0.7 m from one and 2 m high, receiver at 1.2 m: the series of images.
std::vector<Number> facingMirrors() {
  std::vector<Number> numbers;
  for (const double rho : {.5, .88, .95, .99}) {
    ProjectText project;
    project.material("mirror", fmt::format(R"("model": "mirror", "reflectance": {})", rho));
    for (const double x : {0.0, 2.0}) project.rectangle({x, -2000, -1}, {0, 4000, 0}, {0, 0, 4000}, "mirror");
    project.luminaire({0.7, 0, 2}, candela(1000));
    project.points("floor", {{1.2, 0, 0}}, {up});
    const auto results = calculate(project, "0.5 %");
    double lx = 0;
    for (int k = -3000; k <= 3000; ++k)
      for (const double image : {4.0 * k + 0.7, 4.0 * k - 0.7}) {
        // An image's number of reflections is that of the mirrors between it and the room.
        const int reflections = static_cast<int>(std::lround(std::abs(std::floor(image / 2))));
        lx += 1000 * std::pow(rho, reflections) * 2 / std::pow(4 + (1.2 - image) * (1.2 - image), 1.5);
      }
    numbers.push_back(numberAt(fmt::format("ρ {:g}", rho), lx, results.grids[0], 0));
  }
  return numbers;
}

// An isotropic lamp 1 m over water of index 1.33, 0.5 m deep: a ray of angle a in air lands at tan a + 0.5 tan b.
// E = I T(a) sin a da / (r dr). `diameter` 0: a point.
std::vector<Number> underWater(double diameter, const char* accuracy, const std::vector<double>& angles) {
  const double n = 1.33, h = 1, depth = 0.5;
  ProjectText project;
  project.material("water", fmt::format(R"("model": "dielectric", "ior": {})", n));
  project.paint("black", 0);
  project.object(R"("shape": "box", "min": [-10,-10,-0.5], "max": [10,10,0], )"
                 R"("materials": { "*": "water", "floor": "black", "walls": "black" })");
  project.luminaire(
      {0, 0, h},
      candela(1000) + (diameter > 0 ? fmt::format(R"(, "shape": {{ "sphere": {{ "diameter": {} }} }})", diameter)
                                    : R"(, "shape": "point")"));
  const auto landing = [&](double a) { return h * std::tan(a) + depth * std::tan(std::asin(std::sin(a) / n)); };
  std::vector<core::Vec3> points;
  std::vector<double> expected;
  for (const double degrees : angles) {
    const double a = degrees * core::degree, b = std::asin(std::sin(a) / n);
    const double rs = std::pow(std::sin(a - b) / std::sin(a + b), 2),
                 rp = std::pow(std::tan(a - b) / std::tan(a + b), 2);
    const double t = degrees == 0 ? 1 - std::pow((n - 1) / (n + 1), 2) : 1 - 0.5 * (rs + rp);
    const double step = 1e-5;
    const double lx = degrees == 0
                          ? 1000 * t / std::pow(h + depth / n, 2)
                          : 1000 * t * std::sin(a) * 2 * step / (landing(a) * (landing(a + step) - landing(a - step)));
    points.push_back({landing(a), 0, -depth});
    expected.push_back(lx);
  }
  project.points("floor", points, {up});
  const auto results = calculate(project, accuracy);
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < points.size(); ++i)  // a sphere is no point: 0.5 %
    numbers.push_back(numberAt(fmt::format("{:g}° in air, {:.5f} m aside", angles[i], points[i].x), expected[i],
                               results.grids[0], i, diameter > 0 ? 0.005 * expected[i] : 0.0));
  return numbers;
}

// A parabolic mirror of focal length 0.1 m with the lamp in its focus sends a parallel beam, at every distance the
// same.
std::vector<Number> paraboloid() {
  const double f = 0.1, rho = 0.9, candelas = 100;
  std::vector<Number> numbers;
  ProjectText project;
  project.material("mirror", fmt::format(R"("model": "mirror", "reflectance": {})", rho));
  project.surround(1.5);
  project.object(R"("shape": "quadric", "xx": 1, "yy": 1, "z": -0.4, "size": 1, "min": [-0.3,-0.3,-0.01], )"
                 R"("max": [0.3,0.3,0.2], "material": "mirror")");
  project.luminaire({0, 0, f}, candela(candelas) + R"(, "shape": "point")");
  const double places[] = {0, .05, .1, .2};
  std::vector<core::Vec3> points;
  for (const double height : {.6, 1.1})
    for (const double r : places) points.push_back({r, 0, height});
  project.points("beam", points, {{0, 0, -1}});
  const auto results = calculate(project, "0.2 %");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double r = points[i].x, away = points[i].z - f, t = r / (2 * f);
    const double beam = rho * candelas / (f * f * std::pow(1 + t * t, 2));
    const double direct = candelas * away / std::pow(away * away + r * r, 1.5);
    numbers.push_back(numberAt(fmt::format("r {:g} m, {:g} m away", r, away), beam + direct, results.grids[0], i));
  }
  return numbers;
}

}  // namespace

Section mirrorSection() {
  Section section;
  section.title = "Mirrors and refraction";
  section.introduction = "Light that reaches a point by mirrors, flat or curved, or through a surface of water.";
  section.cases = {
      {"4.8", "Lamp over water", "lx", "a point of 1000 cd, 1 m over water of index 1.33 and 0.5 m depth, on its floor",
       "a ray tube's Fresnel transmittance and its cross-section on the floor", "0 lx in plain path tracers", 5e-3, 0,
       false,
       [] {
         return underWater(0, "0.5 %", {0, 20, 40, 60});
       }},
      {"4.8s", "Ball lamp over water", "lx", "the same; the lamp is a sphere of 0.2 m",
       "the same, of a point lamp (0.5 %)", "", 2.5e-2, 0, false,
       [] {
         return underWater(0.2, "2 %", {0, 20, 40});
       }},
      {"4.9", "Parabolic mirror", "lx", "a point of 100 cd in the focus, f 0.1 m, ρ 0.9, on planes that face the beam",
       "ρ I / (f² (1 + (r / 2f)²)²), and the lamp's direct light", "0 lx of the beam in plain path tracers", 5e-3, 0,
       false, paraboloid},
      {"4.10", "Mirror on a wall", "lx", "mirror from 0.5 to 1.5 m height, ρ 0.9; floor at x", "the lamp and its image",
       "", 1e-5, 0, false, mirrorWall},
      {"4.10f", "Two facing mirrors", "lx", "2 m apart, floor between them", "series of images",
       "15 reflections: −1.6 % of the mirrored light at ρ 0.99", 6e-3, 0, false, facingMirrors},
  };
  return section;
}

}  // namespace goniolux::validation
