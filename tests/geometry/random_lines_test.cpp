// Every registered shape against integral geometry: areas from the number of times that random lines cross it, volumes
// from the lengths inside by parity. Neither knows a formula of the shape: only where a line meets it, and, for
// triangles, not even our code.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "geometry/objects.h"
#include "geometry/quadric_intersect.h"
#include "geometry/queries.h"
#include "geometry/samples.h"
#include "support/temporary_folder.h"

namespace goniolux::geometry {
namespace {

using core::Mat4;
using core::Vec3;

constexpr int lines = 1'000'000;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Moller & Trumbore, Journal of Graphics Tools 2 (1997).
bool meetsTriangle(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b, const Vec3& c, double& t) {
  const Vec3 ab = b - a, ac = c - a, p = glm::cross(d, ac), s = o - a, q = glm::cross(s, ab);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0) return false;
  const double u = glm::dot(s, p) / determinant, v = glm::dot(d, q) / determinant;
  t = glm::dot(ac, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1;
}

std::vector<double> crossings(const Shape& shape, const std::vector<Mat4>& toCanonical, const Vec3& o, const Vec3& d) {
  std::vector<double> found;
  for (const auto& triangle : shape.mesh.triangles) {
    double t = 0;
    if (meetsTriangle(o, d, shape.mesh.vertices[triangle[0]], shape.mesh.vertices[triangle[1]],
                      shape.mesh.vertices[triangle[2]], t))
      found.push_back(t);
  }
  for (std::size_t i = 0; i < shape.patches.size(); ++i) {
    double t[mostCrossings];
    const int count = intersectAll(shape.patches[i], Vec3(toCanonical[i] * glm::dvec4(o, 1)),
                                   Vec3(toCanonical[i] * glm::dvec4(d, 0)), -infinity, infinity, t);
    found.insert(found.end(), t, t + count);
  }
  std::sort(found.begin(), found.end());
  return found;
}

struct Sum {
  double first = 0, second = 0;
  void add(double x) { first += x, second += x * x; }
  [[nodiscard]] double mean() const { return first / lines; }
  [[nodiscard]] double error() const { return std::sqrt((second / lines - mean() * mean()) / lines); }
};

TEST(RandomLines, CrossEveryShapeAsOftenAsItsAreaSaysAndStayInsideAsLongAsItsVolumeSays) {
  goniolux::test::TemporaryFolder folder;
  for (const test::Sample& sample : test::samples(folder.path())) {
    SCOPED_TRACE(sample.type + ": " + sample.title);
    const Shape shape = findObjectType(sample.type)->make(sample.arguments);
    std::vector<Mat4> toCanonical;
    for (const QuadricPatch& patch : shape.patches) toCanonical.push_back(glm::inverse(patch.placement));
    const Bounds box = bounds(shape);
    const Vec3 middle = box.center();
    const double radius = 0.5 * glm::length(box.extent()) * 1.001;
    std::mt19937_64 generator(11);
    std::uniform_real_distribution<double> unit(0, 1);
    const int count = shape.mesh.triangles.size() + shape.patches.size() > 100 ? lines / 100 : lines;
    Sum area, inside;
    int odd = 0;
    for (int i = 0; i < count; ++i) {
      const double z = 2 * unit(generator) - 1, phi = 2 * core::pi * unit(generator), r = std::sqrt(1 - z * z);
      const Vec3 d(r * std::cos(phi), r * std::sin(phi), z);
      Vec3 x, y;
      core::perpendiculars(d, x, y);
      const double away = radius * std::sqrt(unit(generator)), angle = 2 * core::pi * unit(generator);
      const Vec3 o = middle + away * (std::cos(angle) * x + std::sin(angle) * y) - 2 * radius * d;
      const auto found = crossings(shape, toCanonical, o, d);
      area.add(double(found.size()) * lines / count);
      if (!shape.closed) continue;
      odd += found.size() % 2 != 0;
      double length = 0;
      for (std::size_t k = 0; k + 1 < found.size(); k += 2) length += found[k + 1] - found[k];
      inside.add(length * lines / count);
    }
    const double scatter = std::sqrt(double(lines) / count);
    // Isotropic lines through a ball of radius R meet a surface of area A in 2 A / (4 pi R^2) points on average
    // (Cauchy-Crofton), and run V / (pi R^2) within a volume V. Five standard errors: fails by chance once in 10^6.
    EXPECT_NEAR(area.mean() * 2 * core::pi * radius * radius, sample.area,
                5 * scatter * area.error() * 2 * core::pi * radius * radius);
    if (!shape.closed) continue;
    EXPECT_NEAR(inside.mean() * core::pi * radius * radius, sample.volume,
                5 * scatter * inside.error() * core::pi * radius * radius);
    // Sides and caps overlap by 1e-9 of a radius, where a line counts twice: far rarer than one in 10^6.
    EXPECT_EQ(odd, 0);
  }
}

}  // namespace
}  // namespace goniolux::geometry
