// Utilisation factors against closed forms and an independently calculated room.
#include "analysis/utilisation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "photometry/metrics.h"
#include "photometry/photometric_file.h"

namespace goniolux::analysis {
namespace {

using core::pi;
using photometry::CosinePowerDistribution;

photometry::PhotometricFile own(const char* name) {
  return photometry::readPhotometricFile(std::string(GONIOLUX_SOURCE_DIR) + "/luminaires/" + name);
}

TEST(FloorToCeiling, IsTheFormFactorOfParallelRectangles) {
  // 6 x 4 m, 2 m high: 0.475576 by another program; a cube: 0.199824896.
  EXPECT_NEAR(floorToCeiling({3, 2}), 0.475576, 1e-6);
  EXPECT_NEAR(floorToCeiling({1, 1}), 0.199824896, 1e-8);
}

TEST(DirectRatio, OfALambertianPlaneIsTheFormFactor) {
  // Luminaires spread evenly whose distribution is Lambertian are a diffusely emitting ceiling.
  const CosinePowerDistribution cosine(100, 1);
  for (const double k : {0.6, 1.0, 2.5, 5.0}) {
    const Cavity cavity = Cavity::square(k);
    EXPECT_NEAR(directRatio(cosine, cavity), floorToCeiling(cavity), 2e-4) << k;
  }
  EXPECT_NEAR(directRatio(cosine, {8, 2}), floorToCeiling({8, 2}), 2e-4);
}

TEST(Exchange, KeepsAllFluxInAWhiteRoomAndNothingTwiceInABlackOne) {
  const CavityFlux first{10, 20, 70};
  const CavityFlux black = exchange(first, 0.3, 2, {0, 0, 0});
  EXPECT_EQ(black.floor, 70);
  EXPECT_EQ(black.walls, 20);
  // What is absorbed is what was given.
  const CavityReflectances rho{0.7, 0.5, 0.2};
  const CavityFlux all = exchange(first, 0.3, 2, rho);
  EXPECT_NEAR(all.ceiling * 0.3 + all.walls * 0.5 + all.floor * 0.8, 100, 1e-9);
}

// A room calculated by another program (validation cases, 6.6): effective reflectances 64.69 % and 18.66 %, direct
// ratio 0.5205; the method's own result is CU = 0.69297.
TEST(UtilisationFactor, MeetsTheWorkedZonalCavityRoom) {
  const Cavity cavity{3, 2};  // 6 x 4 m, 2 m high
  const double found = utilisationFactor(0, 1000, 1000, 0.5205, cavity, {0.6469, 0.5, 0.1866});
  EXPECT_NEAR(found, 0.69297, 1e-4);
}

TEST(UtilisationTables, FallWithDarkerAndNarrowerRooms) {
  const photometry::PhotometricFile panel = own("panel-600.ies");
  for (const UtilisationTable& table : {roomIndexTable(*panel.distribution, panel.distribution->flux()),
                                        zonalCavityTable(*panel.distribution, panel.distribution->flux())}) {
    const bool byIndex = table.rooms.front() == 0.6;
    for (std::size_t i = 0; i < table.rooms.size(); ++i) {
      EXPECT_GT(table.factors[i][0], table.factors[i].back());
      EXPECT_LT(table.factors[i][0], 1.2);
      if (i == 0) continue;
      for (std::size_t r = 0; r < table.reflectances.size(); ++r)
        EXPECT_EQ(table.factors[i][r] >= table.factors[i - 1][r] - 1e-9, byIndex || table.rooms[i] == 0)
            << i << " " << r;
    }
  }
  // Of a Lambertian luminaire in black surroundings the factor is the form factor.
  const UtilisationTable table = roomIndexTable(*panel.distribution, panel.distribution->flux());
  EXPECT_NEAR(table.factors[2].back(), floorToCeiling(Cavity::square(1)), 1e-3);
  // The zonal multipliers are an approximation of the same ratio.
  EXPECT_NEAR(zonalDirectRatio(photometry::zonalLumens(*panel.distribution), 5), floorToCeiling(Cavity::square(1)),
              0.02);
}

TEST(SpacingCriterion, OfALambertianLuminaireIsThatOfTheClosedForm) {
  // I cos^3 = I0 cos^4 = I0 / 2: gamma = acos(2^-1/4), spacing 2 tan(gamma) = 1.287; diagonal: I0 / 4, sqrt 2 tan
  // = 1.414.
  const SpacingCriterion found = spacingCriterion(CosinePowerDistribution(100, 1));
  EXPECT_NEAR(found.c0, 2 * std::tan(std::acos(std::pow(0.5, 0.25))), 0.01);
  EXPECT_NEAR(found.c90, found.c0, 1e-9);
  EXPECT_NEAR(found.diagonal, std::sqrt(2.0), 0.01);
  EXPECT_EQ(spacingCriterion(*own("cove-uplight.ies").distribution).c0, 0);
}

}  // namespace
}  // namespace goniolux::analysis
