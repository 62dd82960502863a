// Scenes where methods fail: every solver of the registry is right within its interval, or says that it cannot, and
// falls behind neither its claim (cases.json) nor what docs/stability.md says of it.
//
// The test suite runs the fast cases. The full suite, which writes the page anew, is script/stability.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "stability/case_table.h"
#include "stability/run_case.h"
#include "stability/stability_page.h"

namespace goniolux::stability {
namespace {

bool isAsked(const char* variable) {
  return std::getenv(variable) != nullptr;
}

CaseOutcome runAloud(const Case& one, const std::string& solver) {
  CaseOutcome outcome = runCase(one, solver);
  fmt::print("{:2} {:<7} {:<9}{:6.1f} s  {}\n", one.number, solver, wordFor(outcome.outcome), outcome.cpuSeconds,
             outcome.detail(one));
  if (isAsked("GONIOLUX_STABILITY_DETAIL"))
    for (std::size_t i = 0; i < outcome.checks.size(); ++i)
      fmt::print("      {:<9}{}: {}\n", wordFor(outcome.checks[i].outcome), one.checks[i].what,
                 outcome.checks[i].detail);
  std::fflush(stdout);
  return outcome;
}

/// What the page says, and nothing of a case or solver that it does not know yet.
Record recorded() {
  return std::filesystem::exists(pageFile()) ? recordFrom(core::readFile(pageFile().string())) : Record{};
}

class StabilityCase : public testing::TestWithParam<Case> {};

TEST_P(StabilityCase, NoSolverFallsBehindItsClaimOrItsRecord) {
  const Case& one = GetParam();
  if (!one.fast) GTEST_SKIP() << "a long case: script/stability runs it";
  const Record record = recorded();
  for (const std::string& solver : solverNames()) {
    const CaseOutcome outcome = runAloud(one, solver);
    Outcome least = one.claimOf(solver);
    std::string by = "its claim in cases.json";
    if (const auto row = record.find(one.number); row != record.end())
      if (const auto entry = row->second.find(solver); entry != row->second.end()) {
        least = entry->second;
        by = "docs/stability.md";
      }
    EXPECT_FALSE(isWorse(outcome.outcome, least))
        << one.title << ", " << solver << ": " << wordFor(outcome.outcome) << ", worse than \"" << wordFor(least)
        << "\" of " << by << "\n  " << outcome.detail(one);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, StabilityCase, testing::ValuesIn(readCases()), [](const auto& parameter) {
  std::string name = parameter.param.folder;
  for (char& c : name)
    if (c == '-') c = '_';
  return "Case" + name;
});

// The page keeps what the solvers claim: an entry that is worse than its claim is a defect that is known, as bad as it
// is known to be.
TEST(StabilityPage, EntriesAreAsGoodAsTheirClaims) {
  const Record record = recorded();
  for (const Case& one : readCases())
    for (const std::string& solver : solverNames()) {
      ASSERT_TRUE(record.contains(one.number) && record.at(one.number).contains(solver))
          << "case " << one.number << ", " << solver << ": not on the page; run script/stability";
      if (const auto* known = one.openDefectOf(solver)) {
        EXPECT_EQ(wordFor(record.at(one.number).at(solver)), wordFor(known->first))
            << "case " << one.number << " (" << one.title << "), " << solver
            << ": no longer so; take it out of the open defects in tests/stability/make";
        continue;
      }
      EXPECT_FALSE(isWorse(record.at(one.number).at(solver), one.claimOf(solver)))
          << "case " << one.number << " (" << one.title << "), " << solver << ": "
          << wordFor(record.at(one.number).at(solver)) << ", claimed is " << wordFor(one.claimOf(solver));
    }
}

// Not a test but the command that writes the page: GONIOLUX_STABILITY_PAGE names the file, GONIOLUX_STABILITY_CASES the
// cases that are run anew (" 6 16 "), all when it is not set.
TEST(StabilityPage, IsWrittenByTheFullSuite) {
  const char* file = std::getenv("GONIOLUX_STABILITY_PAGE");
  if (file == nullptr) GTEST_SKIP() << "script/stability runs all cases and writes docs/stability.md";
  Outcomes outcomes;
  const std::vector<Case> cases = readCases();
  const char* some = std::getenv("GONIOLUX_STABILITY_CASES");
  for (const Case& one : cases) {
    if (some != nullptr && std::string(some).find(fmt::format(" {} ", one.number)) == std::string::npos) continue;
    for (const std::string& solver : solverNames()) outcomes[one.number][solver] = runAloud(one, solver);
  }
  const std::string before = some != nullptr ? core::readFile(file) : "";
  core::writeFile(file, stabilityPage(cases, solverNames(), outcomes, before));
}

}  // namespace
}  // namespace goniolux::stability
