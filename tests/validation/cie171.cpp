// CIE 171:2006, section 5, as far as it is about electric light. The points are those of the report: A to F down the
// centre line of a wall, 0.25 m from the ceiling and every 0.5 m; G to N along the centre line of floor or ceiling.
#include <fmt/format.h>

#include <cmath>

#include "validation/closed_forms.h"
#include "validation/projects.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

using core::pi;
using core::Vec3;

constexpr double inset = 1e-6;  // m, of points before the surface that they lie on
constexpr Vec3 up{0, 0, 1}, down{0, 0, -1};
constexpr double wallHeights[] = {2.75, 2.25, 1.75, 1.25, 0.75, 0.25};         // A to F
constexpr double places[] = {0.25, 0.75, 1.25, 1.75, 2.25, 2.75, 3.25, 3.75};  // G to N

std::string letter(std::size_t index) {
  return {static_cast<char>('A' + index)};
}

std::vector<Number> pointSource(bool lambertian) {
  ProjectText project;
  project.paint("black", 0);
  project.room({4, 4, 3.1}, "black");
  project.luminaire({2, 2, 3}, lambertian ? fmt::format(R"("photometry": "cosine", "flux": {})", 1000 * pi)
                                          : fmt::format(R"("photometry": "isotropic", "flux": {})", 4000 * pi));
  const std::vector<core::Vec2> offsets{{0, 0},  {.5, 0},   {1, 0}, {1.5, 0}, {.5, .5},
                                        {1, .5}, {1.5, .5}, {1, 1}, {1.5, 1}, {1.5, 1.5}};
  std::vector<Vec3> points;
  for (const auto& o : offsets) points.push_back({2 + o.x, 2 + o.y, inset});
  project.points("floor", points, {up});
  const auto results = calculate(project, "1 %");
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const double d2 = 9 + offsets[i].x * offsets[i].x + offsets[i].y * offsets[i].y;
    numbers.push_back(numberAt(fmt::format("({:g}, {:g})", offsets[i].x, offsets[i].y),
                               lambertian ? 1000 * 9 / (d2 * d2) : 1000 * 3 / std::pow(d2, 1.5), results.grids[0], i));
  }
  return numbers;
}

// Points of wall y = 0 and of the floor or ceiling along y, in the middle of x.
void addLines(ProjectText& project, double floorZ, const Vec3& floorNormal) {
  std::vector<Vec3> points, normals;
  for (const double z : wallHeights) points.push_back({2, inset, z}), normals.push_back({0, 1, 0});
  for (const double y : places) points.push_back({2, y, floorZ}), normals.push_back(floorNormal);
  project.points("line", points, normals);
}

std::vector<Number> againstParallelogram(const ProjectText& project, const Vec3& corner, const Vec3& u, const Vec3& v,
                                         double luminance, double floorZ, const Vec3& floorNormal) {
  const auto results = calculate(project, "0.2 %");
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < 14; ++i) {
    const bool wall = i < 6;
    const Vec3 point = wall ? Vec3(2, 0, wallHeights[i]) : Vec3(2, places[i - 6], floorZ);
    numbers.push_back(numberAt(letter(i),
                               luminance * parallelogramFactor(corner, u, v, point, wall ? Vec3(0, 1, 0) : floorNormal),
                               results.grids[0], i));
  }
  return numbers;
}

std::vector<Number> areaSource() {
  ProjectText project;
  project.paint("black", 0);
  project.room({4, 4, 3}, "black");
  project.luminaire({2, 2, 3}, fmt::format(R"("photometry": "cosine", "flux": {}, )"
                                           R"("shape": {{ "rectangle": {{ "length": 1, "width": 1 }} }})",
                                           1000 * pi));
  addLines(project, inset, up);
  return againstParallelogram(project, {1.5, 1.5, 3}, {1, 0, 0}, {0, 1, 0}, 1000, 0, up);
}

// The faces of the room as grids; their sum is the flux.
std::vector<Number> fluxOverFaces(const Vec3& lamp) {
  constexpr int n = 80;
  const Vec3 size(4, 4, 3);
  ProjectText project;
  project.paint("black", 0);
  project.room(size, "black");
  project.luminaire(lamp, R"("photometry": "isotropic", "flux": 10000)");
  project.plane("floor", {0, 0, inset}, {4, 0, 0}, {0, 4, 0}, n, n, up);
  project.plane("ceiling", {0, 0, 3 - inset}, {4, 0, 0}, {0, 4, 0}, n, n, down);
  project.plane("x = 0", {inset, 0, 0}, {0, 4, 0}, {0, 0, 3}, n, n, {1, 0, 0});
  project.plane("x = 4", {4 - inset, 0, 0}, {0, 4, 0}, {0, 0, 3}, n, n, {-1, 0, 0});
  project.plane("y = 0", {0, inset, 0}, {4, 0, 0}, {0, 0, 3}, n, n, {0, 1, 0});
  project.plane("y = 4", {0, 4 - inset, 0}, {4, 0, 0}, {0, 0, 3}, n, n, {0, -1, 0});
  const auto results = calculate(project, "1 %");
  const double perSteradian = 10000 / (4 * pi);
  const double expected[] = {
      rectangleSolidAngle(4, 4, lamp.z, lamp.x, lamp.y), rectangleSolidAngle(4, 4, 3 - lamp.z, lamp.x, lamp.y),
      rectangleSolidAngle(4, 3, lamp.x, lamp.y, lamp.z), rectangleSolidAngle(4, 3, 4 - lamp.x, lamp.y, lamp.z),
      rectangleSolidAngle(4, 3, lamp.y, lamp.x, lamp.z), rectangleSolidAngle(4, 3, 4 - lamp.y, lamp.x, lamp.z)};
  std::vector<Number> numbers;
  Number sum{"sum", 10000, 0, 0, 0};
  for (std::size_t i = 0; i < 6; ++i) {
    const double area = i < 2 ? 16 : 12;
    Number face = numberOf(results.grids[i].name, expected[i] * perSteradian, results.grids[i].mean);
    face.ours *= area;
    face.halfWidth *= area;
    sum.ours += face.ours;
    sum.halfWidth += face.halfWidth;
    numbers.push_back(face);
  }
  numbers.push_back(sum);
  return numbers;
}

// Tregenza's polynomial for the transmittance of 6 mm clear glass over that at normal incidence, as 5.10 and 5.12 use
// it, times 0.88.
double clearGlass(double c) {
  return -.028378 + c * (3.156075 + c * (-3.058376 + c * (-1.428919 + c * (4.014235 - 1.775827 * c))));
}

// A point source over a pane; the angle is that at the pane. Below: I cos^3 / h^2 times the transmittance.
std::vector<Number> glass() {
  const double angles[] = {0, 10, 20, 30, 40, 50, 60, 70, 80};
  ProjectText project;
  project.material("glass", R"("model": "dielectric", "ior": 1.52, "attenuation_per_m": 7.15, "thickness_m": 0.006)");
  project.surround(30);
  project.rectangle({-20, -20, 1}, {40, 0, 0}, {0, 40, 0}, "glass");
  project.luminaire({0, 0, 2}, fmt::format(R"("photometry": "isotropic", "flux": {})", 4000 * pi));
  std::vector<Vec3> points;
  for (const double angle : angles) points.push_back({2 * std::tan(angle * core::degree), 0, 0});
  project.points("floor", points, {up});
  const auto results = calculate(project, "0.2 %");
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double c = std::cos(angles[i] * core::degree), bare = 1000 * c * c * c / 4;
    Number number = numberAt(fmt::format("{:g}°", angles[i]), clearGlass(c), results.grids[0], i);
    number.ours /= bare;
    number.halfWidth /= bare;
    numbers.push_back(number);
  }
  return numbers;
}

// A horizontal diffuse square, evenly lit, seen from the wall 2 m from its centre and the ceiling at 3 m: as an
// emitting surface of 100 lm/m2, so that illuminances are percentages.
std::vector<Number> diffuseReflector(double side) {
  ProjectText project;
  project.surround(2000);
  project.paint("reflector", 0, 100);
  const double half = 0.5 * side;
  project.rectangle({2 - half, 2 - half, 0}, {side, 0, 0}, {0, side, 0}, "reflector");
  addLines(project, 3, down);
  // What lies behind the wall's plane does not shine on it.
  const auto results = calculate(project, "0.2 %");
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < 14; ++i) {
    const bool wall = i < 6;
    const double from = wall ? std::max(0.0, 2 - half) : 2 - half;
    numbers.push_back(
        numberAt(letter(i),
                 100 / pi *
                     parallelogramFactor({2 - half, from, 0}, {side, 0, 0}, {0, 2 + half - from, 0},
                                         wall ? Vec3(2, inset, wallHeights[i]) : Vec3(2, places[i - 6], 3),
                                         wall ? Vec3(0, 1, 0) : down),
                 results.grids[0], i));
  }
  return numbers;
}

// A bright wall y = 4, a black box before it, and what the wall y = 0 and the floor before the box still see.
std::vector<Number> obstruction() {
  ProjectText project;
  project.surround(10);
  project.paint("wall", 0, 100);
  project.paint("black", 0);
  project.rectangle({0, 4, 0}, {4, 0, 0}, {0, 0, 3}, "wall");
  project.object(R"("shape": "box", "min": [0,2.5,0], "max": [4,2.7,1], "material": "black")");
  std::vector<Vec3> points, normals;
  for (const double z : wallHeights) points.push_back({2, 0, z}), normals.push_back({0, 1, 0});
  for (std::size_t i = 0; i < 5; ++i) points.push_back({2, places[i], 0}), normals.push_back(up);
  project.points("line", points, normals);
  const auto results = calculate(project, "0.2 %");
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Over the box one sees the wall from this height on.
    double from = 0;
    for (const double edge : {2.5, 2.7})
      from = std::max(from, points[i].z + (1 - points[i].z) * (4 - points[i].y) / (edge - points[i].y));
    const double factor =
        from >= 3 ? 0 : parallelogramFactor({0, 4, from}, {4, 0, 0}, {0, 0, 3 - from}, points[i], normals[i]);
    numbers.push_back(numberAt(letter(i), 100 / pi * factor, results.grids[0], i));
  }
  return numbers;
}

// The mean over a face by Gauss's rule in a quarter of it: the six faces, and the quarters of each, are alike.
std::vector<Number> interreflection(const std::vector<double>& reflectances) {
  std::vector<Number> numbers;
  for (const double rho : reflectances) {
    ProjectText project;
    project.paint("grey", rho);
    project.room({4, 4, 4}, "grey");
    project.luminaire({2, 2, 2}, R"("photometry": "isotropic", "flux": 10000)");
    std::vector<Vec3> points;
    for (const double u : gaussNodes)
      for (const double v : gaussNodes) points.push_back({2 + 2 * u, 2 + 2 * v, inset});
    project.points("floor", points, {up});
    // Indirect light is the share rho of all: to 1 % of it.
    const auto results = calculate(project, fmt::format("{} %", rho));
    Number number{fmt::format("ρ {:g}", rho), 10000.0 / 96 * rho / (1 - rho), 0, 0, 0};
    double squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double weight = gaussWeights[i / 4] * gaussWeights[i % 4];
      const double x = points[i].x - 2, y = points[i].y - 2,
                   direct = 10000 / (4 * pi) * 2 / std::pow(4 + x * x + y * y, 1.5);
      number.ours += weight * (results.grids[0].values[i] - direct);
      squares += std::pow(weight * results.grids[0].halfWidths[i], 2);
    }
    number.halfWidth = std::sqrt(squares);
    number.uncertainty = 2e-4 * number.reference;  // of Gauss's rule: the edges are not smooth
    numbers.push_back(number);
  }
  return numbers;
}

struct CubePoints {
  double rho, centre, edge, corner;
};

std::vector<Number> interreflectionAtPoints(const std::vector<CubePoints>& rows) {
  std::vector<Number> numbers;
  for (const auto& row : rows) {
    ProjectText project;
    project.paint("grey", row.rho);
    project.room({4, 4, 4}, "grey");
    project.luminaire({2, 2, 2}, R"("photometry": "isotropic", "flux": 10000)");
    project.points("floor", {{2, 2, inset}, {2, 0.5, inset}, {0.5, 0.5, inset}}, {up});
    const auto results = calculate(project, "0.5 %");
    const double expected[] = {row.centre, row.edge, row.corner};
    const char* names[] = {"centre of a face", "0.5 m from the middle of an edge", "0.5 m from a corner"};
    for (std::size_t i = 0; i < 3; ++i)
      numbers.push_back(
          numberAt(fmt::format("ρ {:g}, {}", row.rho, names[i]), expected[i], results.grids[0], i, 2e-4 * expected[i]));
  }
  return numbers;
}

}  // namespace

Section cie171Section() {
  Section section;
  section.title = "CIE 171:2006";
  section.introduction =
      "Test cases to assess the accuracy of lighting computer programs, section 5, with analytical references. Room: 4 "
      "m "
      "× 4 m × 3 m, black, where nothing else is said. The report's printed tables have errors (in 5.7 all of table "
      "19, "
      "found by I. Ashdown); the references here are calculated anew from the descriptions.";
  section.cases = {
      {"1.1", "5.2: Lambertian point source", "lx", "1000 cd, 3 m over a 4 m × 4 m plane; offsets in m",
       "E = I h² / (h² + r²)²", "Iray 0.1 %, AGi32 0.2 %, LightUp 0.16 %, Cycles 0.99 %", 1e-5, 0, false,
       [] { return pointSource(true); }},
      {"1.1i", "5.2: isotropic point source", "lx", "the same with 1000 cd in every direction",
       "E = I h / (h² + r²)^1.5", "", 1e-5, 0, false, [] { return pointSource(false); }},
      {"1.2", "5.3: area source", "lx", "1 m × 1 m, 1000 cd/m², in the middle of the ceiling",
       "double integral over the source, by quadrature", "Iray about 0 %, Cycles 4.94 %", 1e-4, 0, false, areaSource},
      {"1.3", "5.4: conservation of flux, lamp in the middle", "lm",
       "isotropic lamp of 10 000 lm; flux on each face, from 80 × 80 points", "solid angle of the face",
       "Cycles 0.28 %, AGi32 0.31 %", 5e-4, 0, false,
       [] {
         return fluxOverFaces({2, 2, 1.5});
       }},
      {"1.3o", "5.4: conservation of flux, lamp aside", "lm", "the same with the lamp at (1, 2.5, 2) m",
       "solid angle of the face", "", 5e-4, 0, false,
       [] {
         return fluxOverFaces({1, 2.5, 2});
       }},
      {"1.4", "5.5: clear glass of 6 mm", "",
       "point source over a pane of index 1.52 with 7.15 /m of absorption, by angle",
       "directional transmittance of clear glass after Tregenza, as the report uses it (index and absorption are "
       "fitted "
       "to it: 0.5 points)",
       "", 5e-3, 1, false, glass},
      {"1.5", "5.6: diffuse reflector, 4 m", "%", "evenly lit square; percent of its exitance",
       "double integral over the square, by quadrature",
       "Radiance 0.14 % (mean), Cycles 0.25 %, Iray and AGi32 about 0 %", 1e-4, 0, false,
       [] { return diffuseReflector(4); }},
      {"1.5s", "5.6: diffuse reflector, 0.5 m", "%", "the same, small",
       "double integral over the square, by quadrature", "", 1e-4, 0, false, [] { return diffuseReflector(0.5); }},
      {"1.5l", "5.6: diffuse reflector, 500 m", "%", "the same, large",
       "double integral over the square, by quadrature", "", 1e-4, 0, false, [] { return diffuseReflector(500); }},
      {"1.6", "5.7: reflector and obstruction", "%",
       "bright wall 4 m × 3 m behind a black box 1 m high; percent of the wall's exitance",
       "double integral over the part of the wall that is seen, by quadrature", "Radiance 0.14 %, Cycles 1.07 %", 1e-2,
       3, false, obstruction},
      {"1.7", "5.8: interreflection, mean", "lx",
       "cube of 4 m, isotropic 10 000 lm in the middle; indirect light on a face",
       "E = Φ ρ / (S (1 − ρ)), exact for the mean of any closed diffuse room",
       "Radiance 0.3 % to ρ 0.8, −5.7 % at 0.9, −26 % at 0.95; Cycles −12 % at 0.9, −32 % at 0.95 (default settings)",
       3e-3, 0, false,
       [] {
         return interreflection({.1, .2, .3, .4, .5, .6, .7, .8, .9});
       }},
      {"1.7x", "5.8: interreflection, white rooms", "lx", "the same", "E = Φ ρ / (S (1 − ρ))",
       "Radiance −26 % at ρ 0.95, Cycles −32 %", 1e-2, 0, true,
       [] {
         return interreflection({.95, .99});
       }},
      {"1.7p", "5.8: interreflection, points", "lx", "the same room, direct and indirect",
       "integral equation by Nyström's method, three steps extrapolated (2·10⁻⁴); calculated by another program", "",
       1e-2, 0, false,
       [] {
         return interreflectionAtPoints({{.5, 310.983, 210.235, 161.080}, {.9, 1153.33, 1049.35, 985.643}});
       }},
      {"1.7q", "5.8: interreflection, points of a white room", "lx", "the same", "the same", "", 1e-2, 0, true,
       [] {
         return interreflectionAtPoints({{.95, 2196.41, 2092.00, 2025.90}});
       }},
  };
  return section;
}

}  // namespace goniolux::validation
