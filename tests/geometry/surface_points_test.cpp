// Points of surfaces are spread evenly by area: against where random lines meet the placed surface, which knows nothing
// of how points are made.
#include "geometry/surface_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <limits>
#include <random>
#include <utility>

#include "geometry/inside.h"
#include "geometry/objects.h"
#include "geometry/quadric_intersect.h"
#include "geometry/queries.h"
#include "geometry/samples.h"
#include "support/temporary_folder.h"

namespace goniolux::geometry {
namespace {

using core::Mat4;
using core::Vec3;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int cells = 5;

// Counts in cells of the placed shape's box and, within these, by the octant of the normal. Faces of the samples lie at
// round fractions of their boxes, cells' borders do not.
class Counts {
 public:
  explicit Counts(const Bounds& box) : box_(box) {}
  void add(const Vec3& position, const Vec3& normal) {
    std::size_t index = 0;
    for (int k = 0; k < 3; ++k) {
      const double extent = box_.extent()[k];
      const double part = extent > 1e-9 ? (position[k] - box_.min[k]) / extent : 0.5;
      index = index * cells + static_cast<std::size_t>(std::clamp(part * 4.71 + 0.137, 0.0, cells - 1.0));
    }
    // Of what is nearly flat along an axis, rounding decides the sign.
    for (int k = 0; k < 3; ++k) index = 3 * index + (normal[k] > 1e-6 ? 0 : normal[k] < -1e-6 ? 1 : 2);
    ++count_[index];
    ++total_;
  }
  [[nodiscard]] double total() const { return total_; }

  // Two samples of one distribution: chi-square and its degrees of freedom, cells with few points thrown together.
  static std::pair<double, int> compare(const Counts& a, const Counts& b) {
    const double scale = std::sqrt(b.total_ / a.total_);
    double sum = 0, restA = 0, restB = 0;
    int used = -1;
    const auto addCell = [&](double x, double y) {
      if (x + y == 0) return;
      const double difference = x * scale - y / scale;
      sum += difference * difference / (x + y);
      ++used;
    };
    for (std::size_t i = 0; i < a.count_.size(); ++i) {
      if (a.count_[i] + b.count_[i] >= 20) {
        addCell(a.count_[i], b.count_[i]);
      } else {
        restA += a.count_[i], restB += b.count_[i];
      }
    }
    addCell(restA, restB);
    return {sum, used};
  }
  // Exceeded by chance once in a million (Wilson & Hilferty).
  static double limit(int degrees) {
    const double d = std::max(degrees, 1), h = 2 / (9 * d);
    return d * std::pow(1 - h + 4.75 * std::sqrt(h), 3);
  }

 private:
  Bounds box_;
  std::array<double, cells * cells * cells * 27> count_{};
  double total_ = 0;
};

// Isotropic lines through the ball about a surface meet its elements in proportion to their areas (Cauchy-Crofton). Of
// the crossings a quarter is kept, so that those of one line hardly hang together.
Counts whereLinesMeet(const Shape& shape, const Mat4& transform, int wanted) {
  const Bounds box = bounds(shape, transform);
  Counts counts(box);
  std::vector<Mat4> toCanonical;
  std::vector<core::Mat3> normals;
  for (const QuadricPatch& patch : shape.patches) {
    toCanonical.push_back(glm::inverse(transform * patch.placement));
    normals.push_back(glm::transpose(core::Mat3(toCanonical.back())));
  }
  std::vector<Vec3> vertices;
  for (const Vec3& v : shape.mesh.vertices) vertices.emplace_back(transform * glm::dvec4(v, 1));
  const double sign = glm::determinant(core::Mat3(transform)) < 0 ? -1 : 1;
  const Vec3 middle = box.center();
  const double radius = 0.5 * glm::length(box.extent()) * 1.001;
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> unit(0, 1);
  while (counts.total() < wanted) {
    const double z = 2 * unit(generator) - 1, phi = 2 * core::pi * unit(generator), r = std::sqrt(1 - z * z);
    const Vec3 d(r * std::cos(phi), r * std::sin(phi), z);
    Vec3 x, y;
    core::perpendiculars(d, x, y);
    const double away = radius * std::sqrt(unit(generator)), angle = 2 * core::pi * unit(generator);
    const Vec3 o = middle + away * (std::cos(angle) * x + std::sin(angle) * y) - 2 * radius * d;
    const auto met = [&](double t, const Vec3& normal) {
      if (unit(generator) < 0.25) counts.add(o + t * d, glm::normalize(normal));
    };
    for (const auto& t : shape.mesh.triangles) {
      const Vec3 &a = vertices[t[0]], ab = vertices[t[1]] - a, ac = vertices[t[2]] - a, normal = glm::cross(ab, ac);
      const double determinant = -glm::dot(d, normal);
      if (determinant == 0) continue;
      const Vec3 s = o - a, moment = glm::cross(s, d);
      const double u = glm::dot(ac, moment) / determinant, v = -glm::dot(ab, moment) / determinant;
      if (u >= 0 && v >= 0 && u + v <= 1) met(glm::dot(s, normal) / determinant, sign * normal);
    }
    for (std::size_t i = 0; i < shape.patches.size(); ++i) {
      const Vec3 origin(toCanonical[i] * glm::dvec4(o, 1)), direction(toCanonical[i] * glm::dvec4(d, 0));
      double t[mostCrossings];
      const int count = intersectAll(shape.patches[i], origin, direction, -infinity, infinity, t);
      for (int k = 0; k < count; ++k)
        met(t[k], normals[i] * canonicalNormal(shape.patches[i], origin + t[k] * direction));
    }
  }
  return counts;
}

struct Map {
  const char* title;
  Mat4 map{1.0};
};

// None; a similarity with a mirror; unequal scales and a shear.
std::vector<Map> maps() {
  Map mirrored{"mirrored", Mat4(1.0)};
  mirrored.map[0] = {0.72, 0.96, -1.6, 0};
  mirrored.map[1] = {-1.6, 1.2, 0, 0};
  mirrored.map[2] = {-0.96, -1.28, -1.2, 0};
  mirrored.map[3] = {-7, 11, 5, 1};
  Map stretched{"stretched and sheared", Mat4(1.0)};
  stretched.map[0] = {3, 0, 0, 0};
  stretched.map[1] = {0.5, 0.8, 0, 0};
  stretched.map[2] = {0, 0.3, 1.5, 0};
  return {{"as it is"}, mirrored, stretched};
}

constexpr int points = 12'000;

TEST(SurfacePoints, OfEveryTypeAreSpreadByAreaUnderEveryMap) {
  const goniolux::test::TemporaryFolder folder;
  int compared = 0;
  for (const test::Sample& sample : test::samples(folder.path()))
    for (const Map& map : maps()) {
      SCOPED_TRACE(sample.type + ": " + sample.title + ", " + map.title);
      const Shape shape = findObjectType(sample.type)->make(sample.arguments);
      // Many facets make lines slow: fewer of these.
      const int wanted = shape.mesh.triangles.size() + shape.patches.size() > 100 ? points / 10 : points;
      const SurfacePoints sampler(shape, map.map);
      Counts ours(bounds(shape, map.map));
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(wanted); ++i) {
        core::Sampler random(core::combine(3, i), 0);
        const SurfacePlace place = sampler.sample(random);
        ASSERT_NEAR(glm::length(place.normal), 1, 1e-9);
        ASSERT_LT(place.part, shape.partNames.size());
        ours.add(place.position, place.normal);
      }
      const auto [chiSquare, degrees] = Counts::compare(ours, whereLinesMeet(shape, map.map, wanted));
      EXPECT_LT(chiSquare, Counts::limit(degrees)) << degrees << " degrees of freedom";
      EXPECT_NEAR(sampler.density() * area(shape, map.map), 1, 1e-12);
      ++compared;
    }
  EXPECT_GE(compared, 3 * int(objectTypes().size()));
}

// Negative control: points that are even before the map are not so after an uneven one, and the test sees it.
TEST(SurfacePoints, ThatAreMadeBeforeAnUnevenMapAreFoundToBeUneven) {
  const goniolux::test::TemporaryFolder folder;
  int found = 0, round = 0;
  for (const test::Sample& sample : test::samples(folder.path())) {
    const Shape shape = findObjectType(sample.type)->make(sample.arguments);
    if (shape.patches.empty() || sample.type == "disc") continue;
    ++round;
    const Map map = maps().back();
    const SurfacePoints before(shape);
    const core::Mat3 normals = glm::inverseTranspose(core::Mat3(map.map));
    Counts theirs(bounds(shape, map.map));
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(points); ++i) {
      core::Sampler random(core::combine(3, i), 0);
      const SurfacePlace place = before.sample(random);
      theirs.add(Vec3(map.map * glm::dvec4(place.position, 1)), glm::normalize(normals * place.normal));
    }
    const auto [chiSquare, degrees] = Counts::compare(theirs, whereLinesMeet(shape, map.map, points));
    found += chiSquare > Counts::limit(degrees);
  }
  EXPECT_EQ(found, round);
  EXPECT_GE(round, 8);
}

TEST(SurfacePoints, LieOnTheSurfaceAndLookOutOfClosedShapes) {
  const goniolux::test::TemporaryFolder folder;
  for (const test::Sample& sample : test::samples(folder.path())) {
    SCOPED_TRACE(sample.type + ": " + sample.title);
    const Shape shape = findObjectType(sample.type)->make(sample.arguments);
    if (!shape.closed) continue;
    for (const Map& map : maps()) {
      SCOPED_TRACE(map.title);
      const SurfacePoints sampler(shape, map.map);
      const InsideTest inside(shape, map.map);
      const double step = 1e-4 * glm::length(bounds(shape, map.map).extent());
      int wrong = 0;
      for (std::uint32_t i = 0; i < 300; ++i) {
        core::Sampler random(8, i);
        const SurfacePlace place = sampler.sample(random);
        wrong += inside.contains(place.position + step * place.normal) ||
                 !inside.contains(place.position - step * place.normal);
      }
      EXPECT_LE(wrong, 1);  // within a step of an edge either side may be outside
    }
  }
}

TEST(SurfacePoints, OfAShapeWithoutAreaAreRefused) {
  const Shape nothing{{"all"}, {}, {}};
  EXPECT_THROW(SurfacePoints{nothing}, std::invalid_argument);
}

}  // namespace
}  // namespace goniolux::geometry
