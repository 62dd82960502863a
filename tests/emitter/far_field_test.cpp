// How often the distribution is looked at for the illuminance from an opening, near and far: once from some way on,
// more often near by, and right within the bound that is stated everywhere. The table is printed
// (docs/methods/photometry.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "emitter/emitter.h"
#include "emitter/near_field.h"
#include "photometry/photometric_file.h"

namespace goniolux::emitter {
namespace {

using core::Vec3;
using Shape = Opening::Shape;

class Counted final : public photometry::IntensityDistribution {
 public:
  explicit Counted(std::shared_ptr<const IntensityDistribution> of) : of_(std::move(of)) {}
  [[nodiscard]] double intensity(const Vec3& local) const override {
    ++looks;
    return of_->intensity(local);
  }
  [[nodiscard]] double flux() const override { return of_->flux(); }
  [[nodiscard]] double forwardFlux() const override { return of_->forwardFlux(); }
  [[nodiscard]] double maximumIntensity() const override { return of_->maximumIntensity(); }
  [[nodiscard]] std::optional<photometry::IntensityVariation> variation(const Vec3& local,
                                                                        double angle) const override {
    return of_->variation(local, angle);
  }
  mutable int looks = 0;

 private:
  std::shared_ptr<const IntensityDistribution> of_;
};

struct Luminaire {
  const char* file;
  Opening opening;
};
const Luminaire luminaires[] = {
    {"panel-600-microprismatic.ies", {.shape = Shape::rectangle, .length = 0.6, .width = 0.6}},
    {"louvre-4x18.ies", {.shape = Shape::rectangle, .length = 0.58, .width = 0.58}},
    {"linear-pendant.ldt", {.shape = Shape::rectangle, .length = 1.2, .width = 0.06}},
    {"downlight-60.ies", {.shape = Shape::disc, .diameter = 0.15}},
    {"downlight-15.ies", {.shape = Shape::disc, .diameter = 0.075}},
    {"track-spot.ies", {.shape = Shape::disc, .diameter = 0.09}},
    {"wall-washer.ies", {.shape = Shape::rectangle, .length = 0.3, .width = 0.1}},
    {"linear-pendant.ldt", {.shape = Shape::line, .length = 1.2, .axis = {0, 1, 0}}}};

std::shared_ptr<const photometry::TabulatedDistribution> read(const char* file) {
  return photometry::readPhotometricFile(std::string(GONIOLUX_SOURCE_DIR) + "/luminaires/" + file).distribution;
}

Output outputOf(std::shared_ptr<const photometry::IntensityDistribution> distribution) {
  Output output;
  output.distribution = std::move(distribution);
  output.frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  return output;
}

// Straight below, and towards gamma 20 and 50 between and in the planes.
const Vec3 directions[] = {{0, 0, -1},
                           {0.3420201433, 0, -0.9396926208},
                           {0.2418447626, 0.2418447626, -0.9396926208},
                           {0, -0.7660444431, -0.6427876097},
                           {0.6133, 0.4590, -0.6428}};

TEST(FarField, CostsOneLookAndNearByItIsStillRight) {
  std::printf("looks at the distribution, and the largest error of five directions at a tolerance of 1 %%\n");
  std::printf("%-30s", "distance / largest extent");
  const double ratios[] = {0.1, 0.3, 1, 3, 5, 10, 20, 40, 100, 300};
  for (const double q : ratios) std::printf("%13g", q);
  std::printf("\n");
  for (const Luminaire& luminaire : luminaires) {
    const auto counted = std::make_shared<Counted>(read(luminaire.file));
    const auto emitter = makeEmitter(luminaire.opening, Vec3(0), outputOf(counted));
    const double size = largestExtent(luminaire.opening);
    std::printf("%-30s",
                (luminaire.file + std::string(luminaire.opening.shape == Shape::line ? ", line" : "")).c_str());
    for (const double q : ratios) {
      double worst = 0, looks = 0;
      int lit = 0;
      for (const Vec3& direction : directions) {
        const Vec3 point = glm::normalize(direction) * (q * size), up{0, 0, 1};
        if (point.z > -0.05 * size) continue;
        counted->looks = 0;
        const Illuminance found = emitter->illuminance(point, up, 1e-2);
        const int used = counted->looks;
        const Illuminance exact = emitter->illuminance(point, up, 1e-6);
        if (exact.value <= 0) continue;
        ++lit;
        looks += used;
        worst = std::max(worst, std::abs(found.value / exact.value - 1));
        // Close by, where the edge of a beam crosses the opening, a hundredth is easily missed by a little; not at the
        // tolerance of grids.
        EXPECT_LT(std::abs(found.value / exact.value - 1), q < 1 ? 0.05 : 0.01) << luminaire.file << " at " << q;
        EXPECT_LT(std::abs(emitter->illuminance(point, up, 3e-4).value / exact.value - 1), 2e-3)
            << luminaire.file << " at " << q;
        const Vec3 towards = glm::normalize(direction);
        const bool inItsBeam =
            counted->intensity({towards.x, towards.y, -towards.z}) > 0.05 * counted->maximumIntensity();
        if (q >= 300 && inItsBeam) {
          EXPECT_EQ(used, 1) << luminaire.file;
        }
        if (q <= 0.3) {
          EXPECT_GT(used, 16) << luminaire.file;
        }
      }
      std::printf("%5.0f %5.2f %%", lit > 0 ? looks / lit : 0, 100 * worst);
    }
    std::printf("\n");
  }
}

// At the tolerance that grids are calculated with, too, and between the planes. (An estimate from differences of
// quadrature rules is no bound: it may be exceeded now and then.)
TEST(FarField, StaysWithinTheToleranceAtAnyDistance) {
  int receivers = 0, single = 0, outside = 0, beyond = 0;
  for (const Luminaire& luminaire : luminaires) {
    const auto counted = std::make_shared<Counted>(read(luminaire.file));
    const auto emitter = makeEmitter(luminaire.opening, Vec3(0), outputOf(counted));
    const double size = largestExtent(luminaire.opening);
    for (int i = 0; i < 400; ++i) {
      const double gamma = core::pi * (0.02 + 0.44 * ((i * 37) % 400) / 400.0),
                   c = 2 * core::pi * ((i * 0.618) - int(i * 0.618));
      const double q = std::pow(10.0, 0.3 + 2.4 * ((i * 13) % 400) / 400.0);
      const Vec3 point =
          q * size * Vec3(std::sin(gamma) * std::cos(c), std::sin(gamma) * std::sin(c), -std::cos(gamma));
      const Vec3 normal = i % 3 == 0 ? Vec3(0, 0, 1) : glm::normalize(-point + 0.3 * q * size * Vec3(0.3, -0.5, 0.2));
      for (const double tolerance : {1e-2, 1e-3, 3e-4}) {
        counted->looks = 0;
        const Illuminance found = emitter->illuminance(point, normal, tolerance);
        const int looks = counted->looks;
        single += looks == 1;
        const Illuminance exact = emitter->illuminance(point, normal, 1e-6);
        ++receivers;
        const double error = std::abs(found.value - exact.value);
        outside += error > found.bound + exact.bound + 1e-9 * exact.value;
        beyond += error > tolerance * exact.value;
        // Of no matter where all but none of the light goes elsewhere.
        const double dark = 1e-7 * emitter->flux() / (q * q * size * size);
        EXPECT_LT(error, 3 * tolerance * exact.value + dark)
            << luminaire.file << " q " << q << " gamma " << gamma / core::degree << " C " << c / core::degree;
        // One look is taken on a bound that is certain.
        if (looks == 1) {
          EXPECT_LE(error, found.bound + exact.bound + 1e-9 * exact.value) << luminaire.file << " " << q;
        }
      }
    }
  }
  std::printf("%d receivers, %d of them with one look; %d errors beyond their estimate, %d beyond the tolerance\n",
              receivers, single, outside, beyond);
  EXPECT_LT(beyond, receivers / 200);
  EXPECT_LT(outside, receivers / 20);
  EXPECT_GT(single, receivers / 20);
}

// What stands for the far field must see a change of the intensity: bounds against differences tried out.
TEST(IntensityVariation, BoundsWhatDirectionsAroundShow) {
  for (const char* file : {"track-spot.ies", "wall-washer.ies", "louvre-4x18.ies", "street.ldt", "linear-pendant.ldt",
                           "downlight-15.ies", "traced-spot-barn-doors.ies"}) {
    const auto distribution = read(file);
    int bounded = 0;
    for (int i = 0; i < 300; ++i) {
      const double gamma = core::pi * ((i * 7) % 300) / 300.0, c = 2.39996 * i, angle = 0.002 * (1 + i % 40);
      const Vec3 axis(std::sin(gamma) * std::cos(c), std::sin(gamma) * std::sin(c), std::cos(gamma));
      const auto bound = distribution->variation(axis, angle);
      if (!bound) continue;
      ++bounded;
      Vec3 x, y;
      core::perpendiculars(axis, x, y);
      const double here = distribution->intensity(axis), tiny = 1e-9 * distribution->maximumIntensity();
      for (int j = 0; j < 24; ++j) {
        const double turn = 2 * core::pi * j / 24, far = angle * (j % 3 + 1) / 3;
        const Vec3 side = (x * std::cos(turn) + y * std::sin(turn)) * std::sin(far);
        const double one = distribution->intensity(axis * std::cos(far) + side) - here;
        const double other = distribution->intensity(axis * std::cos(far) - side) - here;
        EXPECT_LE(std::abs(one), bound->first + tiny) << file << " gamma " << gamma / core::degree << " " << angle;
        EXPECT_LE(std::abs(0.5 * (one + other)), bound->even + tiny)
            << file << " gamma " << gamma / core::degree << " " << angle;
      }
    }
    EXPECT_GT(bounded, 100) << file;
  }
}

}  // namespace
}  // namespace goniolux::emitter
