// The UGR table: the glare sum against a room calculated by another program, and the identities of the formula.
#include "analysis/ugr_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "analysis/position_index.h"

namespace goniolux::analysis {
namespace {

using core::Vec3;
using photometry::CosinePowerDistribution;

TEST(PositionIndex, MeetsTheFormulasValues) {
  // T/R and H/R of sources; values of Levin's formula by another program.
  const struct {
    double t, h, p;
  } cases[] = {{0, 0.5, 2.860}, {0, 1, 7.059}, {1, 0, 2.050}, {1, 1, 7.030}, {2, 0, 3.516}, {2, 1, 8.295}};
  for (const auto& c : cases)
    EXPECT_NEAR(positionIndex({0, 1, 0}, {0, 0, 1}, glm::normalize(Vec3(c.t, 1, c.h))), c.p, 6e-4) << c.t << " " << c.h;
}

// 8 x 16 m, 32 Lambertian luminaires 0.6 x 0.6 m of 1000 lm 2 m above the eye on a 2 m grid from 1 m, background from
// E_ind = 44.652 lx (endwise, from the middle of the 8 m wall) and 45.121 lx (crosswise, from the 16 m wall).
TEST(GlareSum, MeetsTheRoomOfAnotherProgram) {
  const CosinePowerDistribution cosine(1000 / core::pi, 1);
  const GlareSource source{&cosine, {0.6, 0.6, 0}, false};
  const GlareGrid endwise{4, 8, -3, 1, 2, 2, {1, 0, 0}}, crosswise{8, 4, -7, 1, 2, 2, {1, 0, 0}};
  EXPECT_NEAR(ugr(glareSum(source, endwise, true), 44.652 / core::pi), 17.32, 0.02);
  EXPECT_NEAR(ugr(glareSum(source, endwise, false), 44.652 / core::pi), 17.46, 0.02);
  EXPECT_NEAR(ugr(glareSum(source, crosswise, true), 45.121 / core::pi), 16.49, 0.02);
  EXPECT_NEAR(ugr(glareSum(source, crosswise, false), 45.121 / core::pi), 16.68, 0.02);
}

TEST(UgrTable, RisesByEightLogarithmsOfTheFluxAndFallsWithTheArea) {
  const CosinePowerDistribution one(100, 1), two(200, 1);
  const auto a = ugrTable({&one, {0.6, 0.6, 0}, false}), b = ugrTable({&two, {0.6, 0.6, 0}, false}),
             c = ugrTable({&one, {1.2, 0.6, 0}, false});
  ASSERT_TRUE(a && b && c);
  for (std::size_t room = 0; room < UgrTable::rooms.size(); ++room)
    for (std::size_t r = 0; r < UgrTable::reflectances.size(); ++r) {
      EXPECT_NEAR(b->crosswise[room][r] - a->crosswise[room][r], 8 * std::log10(2), 1e-9);
      EXPECT_NEAR(c->endwise[room][r] - a->endwise[room][r], -8 * std::log10(2), 1e-9);
      EXPECT_NEAR(a->crosswise[room][r], a->endwise[room][r], 1e-9);  // a luminaire of revolution
      if (r == 4) {
        EXPECT_GT(a->crosswise[room][4], a->crosswise[room][0]);  // darker rooms glare more
      }
    }
  EXPECT_FALSE(ugrTable({&one, Vec3(0), false}));
}

}  // namespace
}  // namespace goniolux::analysis
