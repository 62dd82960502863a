// Glare from images with sources of known place, size and luminance.
#include "analysis/image_glare.h"

#include <gtest/gtest.h>

#include <cmath>

namespace goniolux::analysis {
namespace {

using core::Vec3;
using Projection = scene::View::Projection;

scene::View hemisphere(Projection projection, int size = 600) {
  scene::View view;
  view.target = {0, 1, 0};
  view.projection = projection;
  view.verticalFov = core::pi;
  view.width = view.height = size;
  return view;
}

// A uniform surround with a round lamp of half-angle `radius` about `towards`.
image::XyzImage pictureOf(const scene::View& view, double background, double lamp, const Vec3& towards, double radius) {
  image::XyzImage image;
  image.width = view.width;
  image.height = view.height;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const scene::ViewRay ray = scene::rayThrough(view, x + 0.5, y + 0.5);
      const bool hit = ray.inside && glm::dot(ray.direction, towards) > std::cos(radius);
      image.y.push_back(static_cast<float>(!ray.inside ? 0 : hit ? lamp : background));
    }
  image.x = image.z = image.y;
  return image;
}

// Both fisheyes see 2 pi sr; a uniform luminance L gives pi L on the eye (CIE: Lambert's cosine law).
TEST(ImageGlare, HemisphereHasTwoPiAndUniformLuminanceGivesPiTimesIt) {
  for (const Projection projection : {Projection::fisheyeEquidistant, Projection::fisheyeEquisolid}) {
    const scene::View view = hemisphere(projection);
    const ImageGlare glare = glareOf(pictureOf(view, 100, 100, Vec3(0, 1, 0), 0), view, 2000);
    EXPECT_NEAR(glare.solidAngle_sr, 2 * core::pi, 0.02);
    EXPECT_NEAR(glare.verticalIlluminance_lx, 100 * core::pi, 0.5);
    EXPECT_TRUE(glare.sources.empty());
  }
}

// The equisolid projection gives every pixel the same solid angle; that of the whole circle of r pixels is 2 pi.
TEST(ImageGlare, EquisolidPixelsAreAllAlike) {
  const scene::View view = hemisphere(Projection::fisheyeEquisolid);
  const double expected = 2 * core::pi / (core::pi * 300 * 300);
  for (const int x : {300, 350, 450, 580}) EXPECT_NEAR(solidAngleOf(view, x, 300), expected, 0.001 * expected) << x;
}

TEST(ImageGlare, LampIsFoundWithItsLuminanceSizeAndPlaceAndUgrIsTheFormula) {
  for (const Projection projection : {Projection::fisheyeEquidistant, Projection::fisheyeEquisolid}) {
    const scene::View view = hemisphere(projection);
    const double angle = 30 * core::degree, radius = 4 * core::degree;
    const Vec3 towards(0, std::cos(angle), std::sin(angle));
    const ImageGlare glare = glareOf(pictureOf(view, 20, 8000, towards, radius), view, 2000);
    ASSERT_EQ(glare.sources.size(), 1U);
    const ImageSource& source = glare.sources[0];
    const double omega = 2 * core::pi * (1 - std::cos(radius));
    EXPECT_NEAR(source.luminance_cd_m2, 8000, 1e-6);
    EXPECT_NEAR(source.solidAngle_sr, omega, 0.03 * omega);  // 16 pixels across
    EXPECT_GT(glm::dot(source.direction, towards), std::cos(0.2 * core::degree));
    // Guth's index straight above the line of sight at 30 degrees (tau = 0): exp(33.98e-3 * 30 + 21e-5 * 900).
    const double P = std::exp(33.98e-3 * 30 + 21e-5 * 900);
    EXPECT_NEAR(source.positionIndex, P, 0.02 * P);
    const double expected = 8 * std::log10(0.25 / 20 * 8000.0 * 8000 * omega / (P * P));
    EXPECT_NEAR(glare.ugr, expected, 0.2);
    EXPECT_NEAR(glare.background_cd_m2, 20, 0.3);  // less the part that the lamp hides
    const double Ev = glare.verticalIlluminance_lx;
    EXPECT_NEAR(glare.dgp, 5.87e-5 * Ev + 0.0918 * std::log10(1 + 6.4e7 * omega / (std::pow(Ev, 1.87) * P * P)) + 0.16,
                0.003);
  }
}

TEST(ImageGlare, LampBelowTheLineOfSightHasIwatasIndex) {
  const Vec3 forward(0, 1, 0), up(0, 0, 1);
  const auto below = [&](double degrees) {
    return positionIndexAround(forward, up, {0, std::cos(degrees * core::degree), -std::sin(degrees * core::degree)});
  };
  EXPECT_NEAR(below(20), 1 + 0.8 * std::tan(20 * core::degree), 1e-9);
  EXPECT_NEAR(below(45), 1 + 1.2, 1e-9);
}

TEST(ImageGlare, TwoLampsAreTwoSourcesAndTouchingPixelsOne) {
  const scene::View view = hemisphere(Projection::fisheyeEquidistant, 200);
  image::XyzImage image = pictureOf(view, 10, 10, Vec3(0, 1, 0), 0);
  image.y[80 * 200 + 60] = image.y[81 * 200 + 61] = 5000;  // by a corner
  image.y[80 * 200 + 120] = 9000;
  const ImageGlare glare = glareOf(image, view, 2000);
  ASSERT_EQ(glare.sources.size(), 2U);
  EXPECT_EQ(glare.sources[0].luminance_cd_m2, 9000);
  EXPECT_EQ(glare.sources[1].pixels, 2U);
}

}  // namespace
}  // namespace goniolux::analysis
