// Scenes where methods fail: every solver of the registry is right within its interval, or says that it cannot, and
// does not fall behind its claim (cases.json) or behind what docs/stability.md says of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "stability/case_table.h"
#include "stability/run_case.h"

namespace goniolux::stability {
namespace {

class StabilityCase : public testing::TestWithParam<Case> {};

TEST_P(StabilityCase, EachSolverKeepsItsClaim) {
  const Case& one = GetParam();
  for (const std::string& solver : solverNames()) {
    const CaseOutcome outcome = runCase(one, solver);
    fmt::print("{:2} {:<7} {:<9}{:7.1f} s  {}\n", one.number, solver, wordFor(outcome.outcome), outcome.cpuSeconds,
               outcome.detail(one));
    if (std::getenv("GONIOLUX_STABILITY_DETAIL") != nullptr)
      for (std::size_t i = 0; i < outcome.checks.size(); ++i)
        fmt::print("      {:<9}{}: {}\n", wordFor(outcome.checks[i].outcome), one.checks[i].what,
                   outcome.checks[i].detail);
    std::fflush(stdout);
    EXPECT_FALSE(isWorse(outcome.outcome, one.claimOf(solver)))
        << one.title << ", " << solver << ": " << wordFor(outcome.outcome) << ", claimed is "
        << wordFor(one.claimOf(solver)) << "\n  " << outcome.detail(one);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, StabilityCase, testing::ValuesIn(readCases()), [](const auto& parameter) {
  std::string name = parameter.param.folder;
  for (char& c : name)
    if (c == '-') c = '_';
  return "Case" + name;
});

}  // namespace
}  // namespace goniolux::stability
