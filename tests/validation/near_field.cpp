// Direct light near and far from luminous openings: each a project with a black surround, against its closed form.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "emitter/near_field.h"
#include "validation/closed_forms.h"
#include "validation/projects.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

using core::pi;
using core::Vec3;

constexpr Vec3 up{0, 0, 1};
constexpr const char* exact = "0.1 %";

// Points of one project, with their references, in the order in which they are added.
class Points {
 public:
  void add(const std::string& what, const Vec3& point, const Vec3& normal, double reference) {
    points_.push_back(point);
    normals_.push_back(normal);
    what_.push_back(what);
    references_.push_back(reference);
  }
  [[nodiscard]] std::vector<Number> compare(ProjectText project) const {
    project.points("points", points_, normals_);
    const auto results = calculate(project, exact);
    std::vector<Number> numbers;
    for (std::size_t i = 0; i < what_.size(); ++i)
      numbers.push_back(numberAt(what_[i], references_[i], results.grids[0], i));
    return numbers;
  }

 private:
  std::vector<Vec3> points_, normals_;
  std::vector<std::string> what_;
  std::vector<double> references_;
};

ProjectText opening(const Vec3& position, const std::string& luminaire) {
  ProjectText project;
  project.surround(50);
  project.luminaire(position, luminaire);
  return project;
}

std::vector<Number> cosinePowers() {
  std::vector<Number> numbers;
  for (const double m : {0.0, 1.0, 2.0, 10.0, 100.0}) {
    Points points;
    for (const double r : {0.0, 1.0, 2.0, 4.0}) {
      const double cosine = 3 / std::hypot(3, r), lx = 1000 * std::pow(cosine, m + 3) / 9;
      if (lx > 1e-4) points.add(fmt::format("m {:g}, r {:g} m", m, r), {r, 0, 0}, up, lx);
    }
    const std::string photometry =
        m == 0 ? fmt::format(R"("photometry": "isotropic", "flux": {})", 4000 * pi)
               : fmt::format(R"("photometry": {{ "cosine_power": {} }}, "flux": {})", m, 2000 * pi / (m + 1));
    for (const Number& number : points.compare(opening({0, 0, 3}, photometry))) numbers.push_back(number);
  }
  return numbers;
}

std::vector<Number> disc() {
  const double a = 0.5, luminance = 1000;
  Points points;
  for (const double d : {.01, .1, .5, 1.0, 2.5, 5.0}) {
    for (const double r : {0.0, .25, .5, 1.0, 2.0, 5.0})
      points.add(fmt::format("parallel, d {:g} m, r {:g} m", d, r), {r, 0, -d}, up, luminance * discParallel(a, d, r));
    for (const double r : {.5, 1.0, 2.0, 5.0})
      points.add(fmt::format("perpendicular, d {:g} m, r {:g} m", d, r), {r, 0, -d}, {-1, 0, 0},
                 luminance * discPerpendicular(a, d, r));
  }
  return points.compare(opening({0, 0, 0}, fmt::format(R"("photometry": "cosine", "flux": {}, )"
                                                       R"("shape": {{ "disc": {{ "diameter": 1 }} }})",
                                                       luminance * pi * pi * a * a)));
}

std::vector<Number> rectangle() {
  const double l = 1.2, w = 0.3, h = 2.2, luminance = 5000;
  const Vec3 corner(-l / 2, -w / 2, h), u(l, 0, 0), v(0, w, 0);
  Points points;
  for (const core::Vec2 at : {core::Vec2(0, 0), core::Vec2(.6, 0), core::Vec2(1, 0), core::Vec2(2, 0), core::Vec2(0, 1),
                              core::Vec2(0, 2), core::Vec2(2, 2), core::Vec2(5, 0)})
    points.add(fmt::format("facing up, ({:g}, {:g})", at.x, at.y), {at.x, at.y, 0}, up,
               luminance * parallelogramFactor(corner, u, v, {at.x, at.y, 0}, up));
  for (const double x : {.3, .6, 1.0, 2.0, 5.0}) {
    // What lies behind the upright plane is cut off.
    const Vec3 seen(std::min(x, l / 2) + l / 2, 0, 0);
    points.add(fmt::format("upright, x {:g} m{}", x, x < l / 2 ? ", the source cut by the horizon" : ""), {x, 0, 0},
               {-1, 0, 0}, luminance * parallelogramFactor(corner, seen, v, {x, 0, 0}, {-1, 0, 0}));
  }
  return points.compare(opening({0, 0, h}, fmt::format(R"("photometry": "cosine", "flux": {}, )"
                                                       R"("shape": {{ "rectangle": {{ "length": {}, "width": {} }} }})",
                                                       luminance * pi * l * w, l, w)));
}

std::vector<Number> sphere() {
  Points points;
  for (const double angle : {0.0, 30.0, 60.0, 80.0, 84.26, 87.0, 90.0, 93.0, 95.7, 96.0}) {
    const double a = angle * core::degree;
    points.add(fmt::format("{:g}°", angle), {0, 0, 0}, {std::sin(a), 0, std::cos(a)},
               1e4 * sphereFactor(std::asin(0.1), a));
  }
  return points.compare(opening({0, 0, 1}, fmt::format(R"("photometry": "diffuse", "flux": {}, )"
                                                       R"("shape": {{ "sphere": {{ "diameter": 0.2 }} }})",
                                                       1e4 * pi * 4 * pi * 0.01)));
}

// The far field of a Lambertian line along C0: the same in every direction across it.
class LineDistribution final : public photometry::IntensityDistribution {
 public:
  [[nodiscard]] double intensity(const Vec3& local) const override {
    return std::sqrt(std::max(0.0, 1 - local.x * local.x));
  }
  [[nodiscard]] double flux() const override { return pi * pi; }
  [[nodiscard]] double forwardFlux() const override { return pi * pi / 2; }
  [[nodiscard]] double maximumIntensity() const override { return 1; }
};

// A line is no surface that a project could call diffuse: the emitter itself.
std::vector<Number> line() {
  const double l = 1.2, perMetre = 1000;
  emitter::Output diffuse;
  diffuse.flux_lm = pi * pi * perMetre * l;
  const auto found = emitter::makeEmitter({.shape = emitter::Opening::Shape::line, .length = l, .axis = {1, 0, 0}},
                                          {0, 0, 0}, diffuse);
  std::vector<Number> numbers;
  for (const double d : {.1, .3, .6, 1.2, 2.4, 6.0, 12.0}) {
    const auto add = [&](const char* what, const Vec3& point, const Vec3& normal, double lx) {
      numbers.push_back({fmt::format("{}, d {:g} m", what, d), lx, found->illuminance(point, normal, 1e-5).value, 0});
    };
    add("facing, before the middle", {0, 0, -d}, up, lineBeforeCentre(l, d, perMetre));
    add("facing, before an end", {l / 2, 0, -d}, up, lineBeforeEnd(l, d, perMetre));
    add("across, before an end", {l / 2, 0, -d}, {-1, 0, 0}, lineAcrossEnd(l, d, perMetre));
  }
  return numbers;
}

std::vector<Number> tube() {
  const double l = 1.2, radius = 0.013, luminance = 1e4;
  Points points;
  for (const double h : {.014, .02, .03, .05, .1, .3, 1.0, 3.0})
    points.add(fmt::format("h {:g} m", h), {l / 2, 0, -h}, up, tubeUnderEnd(radius, l, luminance, h));
  return points.compare(opening({0, 0, 0}, fmt::format(R"("photometry": "diffuse", "flux": {}, )"
                                                       R"("shape": {{ "tube": {{ "length": {}, "diameter": {} }} }})",
                                                       luminance * pi * 2 * pi * radius * l, l, 2 * radius)));
}

std::vector<Number> fiveTimesRule() {
  using emitter::Opening;
  const auto output = [](double exponent) {
    emitter::Output made;
    made.distribution = std::make_shared<photometry::CosinePowerDistribution>(1.0, exponent);
    return made;
  };
  const Opening disc{.shape = Opening::Shape::disc, .diameter = 1};
  const Opening square{.shape = Opening::Shape::rectangle, .length = 1, .width = 1};
  const Opening line{.shape = Opening::Shape::line, .length = 1, .axis = {1, 0, 0}};
  emitter::Output across;
  across.distribution = std::make_shared<LineDistribution>();
  constexpr double q[] = {.5, 1, 2, 3, 5, 7, 10};
  const struct {
    const char* name;
    const Opening& opening;
    emitter::Output output;
    int n;
    double percent[7];
  } rows[] = {
      {"disc", disc, output(1), 1, {100, 25, 6.25, 2.77778, 1, .510204, .25}},
      {"square", square, output(1), 1, {129.774, 32.9302, 8.30162, 3.69712, 1.33246, .680043, .333278}},
      {"line", line, across, 1, {55.5938, 15.788, 4.1075, 1.83999, .665118, .339732, .16657}},
      {"disc, cos¹⁰", disc, output(10), 1, {462.428, 94.5074, 21.2343, 9.21322, 3.27425, 1.66449, .814022}},
      {"disc, cos¹⁰⁰", disc, output(100), 1, {4950, 1162.52, 231.127, 87.2024, 27.855, 13.6887, 6.57007}},
      {"square, 2 × 2 points", square, output(1), 2, {2.12187, 5.03124, 1.83734, .875565, .326683, .168328, .0829143}},
      {"square, 4 × 4", square, output(1), 4, {1.6161, 1.20824, .448014, .216187, .0812854, .041979, .0207035}},
      {"square, 8 × 8", square, output(1), 8, {.410444, .298498, .11133, .0538821, .0202975, .0104883, .00517432}},
  };
  std::vector<Number> numbers;
  for (const auto& row : rows)
    for (std::size_t i = 0; i < 7; ++i)
      numbers.push_back({fmt::format("{}, d/L {:g}", row.name, q[i]), row.percent[i],
                         100 * emitter::cutError(row.opening, row.output, q[i], row.n).value_or(-100), 0});
  return numbers;
}

}  // namespace

Section nearFieldSection() {
  Section section;
  section.title = "Direct light, near and far";
  section.introduction =
      "Every luminous opening against its closed form, down to a hundredth of its size. No chance is involved.";
  section.cases = {
      {"2.1", "Point source, I₀ cosᵐ γ", "lx", "1000 cd, 3 m over the plane, r aside", "E = I₀ cosᵐ⁺³ γ / h²", "", 1e-6,
       0, false, cosinePowers},
      {"2.2", "Disc", "lx", "radius 0.5 m, 1000 cd/m²; receiver parallel, or perpendicular and facing the axis",
       "Yamauti 1924", "", 1e-5, 0, false, disc},
      {"2.3", "Rectangle", "lx", "1.2 m × 0.3 m at 2.2 m, 5000 cd/m²", "double integral over the source, by quadrature",
       "", 1e-5, 0, false, rectangle},
      {"2.4", "Sphere across the horizon", "lx",
       "radius 0.1 m at 1 m, 10 000 cd/m²; angle between the normal and the centre (a point source gives nothing "
       "beyond "
       "90°)",
       "integral over the cone in which it is seen", "", 1e-4, 1e-3, false, sphere},
      {"2.5", "Lambertian line", "lx", "1.2 m, 1000 cd per metre across", "E = I'/d (α + sin α cos α) and I'/2d sin² α",
       "", 1e-5, 0, false, line},
      {"2.6", "Tube", "lx", "T8: diameter 26 mm, 1.2 m, 10 000 cd/m²; under one end, h from the axis",
       "strips of the visible half, each in closed form along its length", "", 5e-4, 0, false, tube},
      {"2.7", "Five-times rule: error of the point model", "%",
       "a luminaire as one point, or as a few, at distance d over its largest dimension L",
       "closed forms, calculated by another program", "", 2e-3, 0.05, false, fiveTimesRule},
  };
  return section;
}

}  // namespace goniolux::validation
