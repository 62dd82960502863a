// Surfaces of revolution: what is refused, which side is the front, and how close a spline's cones are to it.
#include "geometry/revolution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/queries.h"

namespace goniolux::geometry {
namespace {

using core::Vec2;
using core::Vec3;

std::string refusal(const std::vector<Vec2>& profile) {
  try {
    makeRevolution(profile, Vec3(0), Vec3(0, 0, 1));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::vector<Vec2> halfCircle(int count, double radius) {
  std::vector<Vec2> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = core::pi * i / count;
    points.emplace_back(i == 0 || i == count ? 0.0 : radius * std::sin(angle), -radius * std::cos(angle));
  }
  return points;
}

TEST(Revolution, BadProfilesAreRefusedWithTheNumberOfThePoint) {
  EXPECT_NE(refusal({{1, 0}}).find("two or more"), std::string::npos);
  EXPECT_NE(refusal({{1, 0}, {-1, 2}}).find("point 2"), std::string::npos);
  EXPECT_NE(refusal({{1, 0}, {1, 1}, {1, 1}}).find("points 2 and 3"), std::string::npos);
  EXPECT_NE(refusal({{0, 0}, {0, 1}}).find("on the axis"), std::string::npos);
  EXPECT_NE(refusal({{0, 0}, {2, 2}, {2, 0}, {1, 3}}).find("crosses"), std::string::npos);
  EXPECT_NE(refusal({{0, 0}, {2, 0}, {1, 0}, {1, 2}}).find("crosses"), std::string::npos) << "straight back";
  EXPECT_NE(refusal({{NAN, 0}, {1, 1}}).find("not finite"), std::string::npos);
  EXPECT_EQ(refusal({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0.5}, {0, 0.5}}), "");
}

TEST(Revolution, AnOpenProfileHasItsFrontOnTheRightOfItsWay) {
  const std::vector<Vec2> up{{1, 0}, {2, 3}}, down{{2, 3}, {1, 0}};
  // A cone that opens upwards, seen from outside, looks down.
  EXPECT_LT(vectorArea(makeRevolution(up, Vec3(0), Vec3(0, 0, 1))).z, 0);
  EXPECT_GT(vectorArea(makeRevolution(down, Vec3(0), Vec3(0, 0, 1))).z, 0);
  EXPECT_NEAR(vectorArea(makeRevolution({{1, 0}, {2, 0}}, Vec3(0), Vec3(0, 0, 1))).z, -3 * core::pi, 1e-12);
}

TEST(Revolution, ASplineThroughPointsOfACircleTendsToTheSphereWithThirdOrderOrBetter) {
  double previous = 0;
  for (const int count : {8, 16, 32}) {
    const auto curve = splineProfile(halfCircle(count, 1), 1e-7);
    const double error = std::abs(volume(makeRevolution(curve, Vec3(0), Vec3(0, 0, 1))) - 4 * core::pi / 3);
    if (previous > 0) {
      EXPECT_GT(previous / error, 7) << "Catmull-Rom tangents are good to second order: at least third in the curve";
    }
    previous = error;
  }
  EXPECT_LT(previous, 1e-4);
}

TEST(Revolution, ChordsAreAsCloseToTheSplineAsAskedAndConvergeWithSecondOrder) {
  const auto points = halfCircle(6, 1);
  const double exact = volume(makeRevolution(splineProfile(points, 1e-6), Vec3(0), Vec3(0, 0, 1)));
  double previousError = 0;
  std::size_t previousCount = 0;
  for (const double chordError : {1e-2, 1e-4}) {
    const auto curve = splineProfile(points, chordError);
    for (const Vec2& p : points) EXPECT_NE(std::find(curve.begin(), curve.end(), p), curve.end());
    const double error = std::abs(volume(makeRevolution(curve, Vec3(0), Vec3(0, 0, 1))) - exact);
    EXPECT_LT(error, 4 * core::pi * chordError) << "area times chord error";
    if (previousCount > 0) {
      const double order = std::log(previousError / error) / std::log(double(curve.size()) / double(previousCount));
      EXPECT_NEAR(order, 2, 0.35);
    }
    previousError = error;
    previousCount = curve.size();
  }
}

TEST(Revolution, ASplineMeetsTheAxisAtARightAngleAndClosesSmoothly) {
  const auto curve = splineProfile({{0, 0}, {1, 0.5}, {0, 2}}, 1e-6);
  EXPECT_LT(std::abs((curve[1].y - curve[0].y) / (curve[1].x - curve[0].x)), 1e-2);
  const auto ring = splineProfile({{2, 0}, {3, 1}, {2, 2}, {1, 1}, {2, 0}}, 1e-6);
  const Vec2 first = glm::normalize(ring[1] - ring[0]), last = glm::normalize(ring.back() - ring[ring.size() - 2]);
  EXPECT_GT(glm::dot(first, last), 1 - 1e-4);
  EXPECT_THROW(splineProfile(halfCircle(4, 1), 1e-12), std::invalid_argument) << "a million cones";
  EXPECT_THROW(splineProfile({{1, 0}, {0.001, 1}, {0.001, 1.1}, {2, 1.2}}, 1e-6), std::invalid_argument)
      << "swings through the axis";
}

}  // namespace
}  // namespace goniolux::geometry
