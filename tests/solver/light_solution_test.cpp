// The cells and the arithmetic of the light solution, on systems that can be solved by hand.
#include "solver/light_solution.h"

#include <gtest/gtest.h>

namespace goniolux::solver {
namespace {

using core::Vec3;

TEST(LightSolution, FindsTheCellOfEveryPointThatWasAdded) {
  LightSolution solution(0.25, 1, 1);
  for (int i = 0; i < 5000; ++i)
    solution.add(static_cast<std::uint32_t>(i % 7), Vec3(0.013 * i, -0.007 * i, 0.002 * i), Vec3(0, 0, i % 2 ? 1 : -1));
  EXPECT_GT(solution.cellCount(), 500u);
  EXPECT_LT(solution.cellCount(), 5000u);
  for (int i = 0; i < 5000; ++i) {
    const auto surface = static_cast<std::uint32_t>(i % 7);
    const std::uint32_t cell =
        solution.find(surface, Vec3(0.013 * i, -0.007 * i, 0.002 * i), Vec3(0, 0, i % 2 ? 1 : -1));
    ASSERT_NE(cell, LightSolution::none);
    EXPECT_EQ(solution.surfaceOf(cell), surface);
  }
  EXPECT_EQ(solution.find(0, Vec3(1000), Vec3(0, 0, 1)), LightSolution::none);
}

TEST(LightSolution, TheTwoSidesOfASurfaceAreDifferentCells) {
  LightSolution solution(1, 1, 1);
  EXPECT_NE(solution.add(0, Vec3(0), Vec3(0, 0, 1)), solution.add(0, Vec3(0), Vec3(0, 0, -1)));
}

// Two cells that see only each other: E1 = D + pi L2, E2 = pi L1, L = rho E / pi, so E1 = D / (1 - rho1 rho2).
TEST(LightSolution, TwoFacingCellsReachTheGeometricSeries) {
  LightSolution solution(1, 1, 2);
  const std::uint32_t a = solution.add(0, Vec3(0), Vec3(0, 0, 1)), b = solution.add(1, Vec3(0, 0, 1), Vec3(0, 0, -1));
  LightSolution::Transport transport;
  transport.direct = {100, 100, 0, 0};
  transport.reflectance = {0.5f, 0.9f, 0.5f, 0.9f};
  transport.linksPerCell = 1;
  transport.links = {{b, LightSolution::none}, {a, LightSolution::none}};
  solution.solve(transport, 1e-7);
  const double rho[2] = {0.5, 0.9};
  for (int k = 0; k < 2; ++k) {
    const double e1 = 100 / (1 - rho[k] * rho[k]), e2 = rho[k] * e1;
    EXPECT_NEAR(static_cast<double>(solution.radiance(a, 0)[k]), rho[k] * e1 / core::pi, 1e-4 * e1);
    EXPECT_NEAR(static_cast<double>(solution.radiance(b, 0)[k]), rho[k] * e2 / core::pi, 1e-4 * e1);
  }
}

// The same with a mirror of reflectance 0.5 in between one way.
TEST(LightSolution, LinksByMirrorsAreFiltered) {
  LightSolution solution(1, 1, 1);
  const std::uint32_t a = solution.add(0, Vec3(0), Vec3(0, 0, 1)), b = solution.add(1, Vec3(0, 0, 1), Vec3(0, 0, -1));
  LightSolution::Transport transport;
  transport.direct = {100, 0};
  transport.reflectance = {0.8f, 0.8f};
  transport.linksPerCell = 1;
  transport.links = {{b, LightSolution::none}, {a, 0}};
  transport.filters = {0.5f};
  solution.solve(transport, 1e-7);
  const double e1 = 100 / (1 - 0.8 * 0.8 * 0.5);
  EXPECT_NEAR(static_cast<double>(*solution.radiance(b, 0)), 0.8 * (0.8 * e1 * 0.5) / core::pi, 1e-3);
}

}  // namespace
}  // namespace goniolux::solver
