// A shape's tessellated twin tends to it with the second order of its sides, and turns the same way.
#include "geometry/tessellate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/bspline_surface.h"
#include "geometry/mesh_checks.h"
#include "geometry/objects.h"
#include "geometry/parametric.h"
#include "geometry/queries.h"
#include "geometry/samples.h"
#include "support/temporary_folder.h"

namespace goniolux::geometry {
namespace {

using core::Vec3;

TEST(Tessellation, OfEveryShapeTendsToItsAreaAndVolumeWithSecondOrder) {
  goniolux::test::TemporaryFolder folder;
  for (const test::Sample& sample : test::samples(folder.path())) {
    const Shape shape = findObjectType(sample.type)->make(sample.arguments);
    if (shape.patches.empty()) continue;
    SCOPED_TRACE(sample.type + ": " + sample.title);
    double errors[2], volumes[2];
    for (const int k : {0, 1}) {
      Shape twin;
      twin.partNames = shape.partNames;
      twin.closed = shape.closed;
      twin.mesh = tessellate(shape, k == 0 ? 24 : 48);
      errors[k] = std::abs(area(twin) - sample.area) / sample.area;
      volumes[k] = shape.closed ? std::abs(volume(twin) - sample.volume) / sample.volume : 0;
      if (shape.closed) {
        EXPECT_GT(volume(twin), 0) << "fronts outside";
      } else {
        EXPECT_GT(glm::dot(vectorArea(twin), vectorArea(shape)), -1e-9) << "the same front";
      }
    }
    EXPECT_LT(errors[1], 0.01);
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.3);
    if (shape.closed) {
      EXPECT_NEAR(std::log2(volumes[0] / volumes[1]), 2, 0.3);
    }
  }
}

TEST(Tessellation, OfAClosedQuadricIsWatertight) {
  goniolux::test::TemporaryFolder folder;
  for (const test::Sample& sample : test::samples(folder.path())) {
    if (sample.type != "quadric" || sample.volume == 0) continue;
    const Mesh mesh = tessellate(findObjectType("quadric")->make(sample.arguments), 20);
    EXPECT_TRUE(checkEdges(mesh).watertight());
  }
}

// The unit sphere's octant is no polynomial; a bicubic through its corners stands for a wavy roof here.
std::vector<std::vector<Vec3>> wave() {
  std::vector<std::vector<Vec3>> net;
  for (int i = 0; i < 5; ++i) {
    net.emplace_back();
    for (int j = 0; j < 6; ++j) net.back().emplace_back(i, j, std::sin(1.7 * i) * std::cos(0.9 * j));
  }
  return net;
}

// Bernstein's form, term by term: another way than de Boor's.
Vec3 bernstein(const std::vector<std::vector<Vec3>>& net, double u, double v) {
  const auto weight = [](std::size_t n, std::size_t k, double t) {
    return std::tgamma(double(n) + 1) / std::tgamma(double(k) + 1) / std::tgamma(double(n - k) + 1) *
           std::pow(t, double(k)) * std::pow(1 - t, double(n - k));
  };
  Vec3 sum(0);
  for (std::size_t i = 0; i < net.size(); ++i)
    for (std::size_t j = 0; j < net[i].size(); ++j)
      sum += weight(net.size() - 1, i, u) * weight(net[i].size() - 1, j, v) * net[i][j];
  return sum;
}

TEST(BsplineSurface, WithoutInnerKnotsIsTheBezierPatchOfBernsteinsForm) {
  const BsplineSurface patch(wave(), 4, 5);
  for (const double u : {0.0, 0.2, 0.55, 1.0})
    for (const double v : {0.0, 0.31, 0.8, 1.0})
      EXPECT_LT(glm::distance(patch.at(u, v), bernstein(wave(), u, v)), 1e-13) << u << ' ' << v;
}

TEST(BsplineSurface, SecondDerivativesStayBelowTheirBounds) {
  for (const int degree : {2, 3}) {
    const BsplineSurface surface(wave(), degree, degree);
    const auto bound = surface.secondDerivatives();
    const double h = 1e-4;
    double uu = 0, uv = 0, vv = 0;
    for (double u = 0.0137; u < 0.99; u += 0.031) {
      for (double v = 0.0091; v < 0.99; v += 0.029) {
        const auto at = [&](int i, int j) { return surface.at(u + i * h, v + j * h); };
        uu = std::max(uu, glm::length(at(1, 0) - 2.0 * at(0, 0) + at(-1, 0)) / (h * h));
        vv = std::max(vv, glm::length(at(0, 1) - 2.0 * at(0, 0) + at(0, -1)) / (h * h));
        uv = std::max(uv, glm::length(at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * h * h));
      }
    }
    EXPECT_LE(uu, bound.uu * 1.001);
    EXPECT_LE(uv, bound.uv * 1.001);
    EXPECT_LE(vv, bound.vv * 1.001);
    EXPECT_GT(uu, 0.2 * bound.uu) << "a bound, not a guess far away";
  }
}

TEST(Parametric, TrianglesAreAsCloseAsAskedAndTheAreaConvergesWithTheChordError) {
  const double exact = area(makeParametric({wave()}, 3, 3, 1e-4));
  double previous = 0;
  for (const double chordError : {3e-2, 3e-3}) {
    const Shape shape = makeParametric({wave()}, 3, 3, chordError);
    EXPECT_EQ(shape.chordError, chordError);
    // The middle of every triangle against the nearest points of a fine net of the surface.
    const BsplineSurface surface(wave(), 3, 3);
    double worst = 0;
    for (std::size_t k = 0; k < shape.mesh.triangles.size(); k += 7) {
      const auto& t = shape.mesh.triangles[k];
      const Vec3 middle = (shape.mesh.vertices[t[0]] + shape.mesh.vertices[t[1]] + shape.mesh.vertices[t[2]]) / 3.0;
      double nearest = 1e9;
      for (int i = 0; i <= 120; ++i)
        for (int j = 0; j <= 120; ++j)
          nearest = std::min(nearest, glm::distance(middle, surface.at(i / 120.0, j / 120.0)));
      worst = std::max(worst, nearest);
      if (k > 1400) break;
    }
    EXPECT_LT(worst, chordError + 0.04) << "the net's own pitch is 0.04";
    const double error = std::abs(area(shape) - exact) / exact;
    EXPECT_LT(error, 30 * chordError);
    if (previous > 0) {
      EXPECT_NEAR(std::log10(previous / error), 1, 0.35);
    }
    previous = error;
  }
}

TEST(Parametric, PatchesThatShareEdgesCloseWithoutCracks) {
  // Six bulging faces of a cube as Bezier patches of degree 2, one after the other.
  std::vector<std::vector<std::vector<Vec3>>> faces;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      std::vector<std::vector<Vec3>> net;
      for (int i = -1; i <= 1; ++i) {
        net.emplace_back();
        for (int j = -1; j <= 1; ++j) {
          Vec3 p(0);
          p[axis] = side * (i == 0 && j == 0 ? 3 : i == 0 || j == 0 ? 1.5 : 1);
          p[(axis + 1) % 3] = i * (j == 0 ? 1.5 : 1.0);
          p[(axis + 2) % 3] = j * (i == 0 ? 1.5 : 1.0);
          net.back().push_back(p);
        }
      }
      faces.push_back(net);
    }
  }
  const Shape shape = makeParametric(faces, 2, 2, 1e-3);
  EXPECT_TRUE(shape.closed);
  EXPECT_GT(volume(shape), 8);
}

TEST(Parametric, UnevenRowsAndTooFineErrorsAreRefused) {
  auto uneven = wave();
  uneven[2].pop_back();
  EXPECT_THROW(makeParametric({uneven}, 3, 3, 1e-3), std::invalid_argument);
  EXPECT_THROW(makeParametric({wave()}, 5, 3, 1e-3), std::invalid_argument) << "five rows, degree 4 at most";
  EXPECT_THROW(makeParametric({wave()}, 3, 3, 1e-9), std::invalid_argument);
}

}  // namespace
}  // namespace goniolux::geometry
