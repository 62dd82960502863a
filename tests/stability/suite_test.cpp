// The suite itself: its table is whole, its page reads back, and what is off is seen to be off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

#include "stability/judge.h"
#include "stability/stability_page.h"

namespace goniolux::stability {
namespace {

TEST(StabilityTable, HasAllFortyCasesWithTheirProjects) {
  const std::vector<Case> cases = readCases();
  std::set<int> numbers;
  const std::vector<std::string> solvers = solverNames();
  for (const Case& one : cases) {
    numbers.insert(one.number);
    EXPECT_FALSE(one.checks.empty()) << one.title;
    for (const Check& check : one.checks)
      EXPECT_TRUE(std::filesystem::exists(casesFolder() / one.folder / check.project));
    for (const auto& [solver, claim] : one.claims)
      EXPECT_TRUE(solver == "*" || std::find(solvers.begin(), solvers.end(), solver) != solvers.end())
          << one.title << " names the solver " << solver;
    // `auto` gives up nothing: right, or refused where there is no answer.
    EXPECT_FALSE(isWorse(one.claimOf("auto"), Outcome::right)) << one.title;
  }
  EXPECT_EQ(numbers.size(), 40u);
  EXPECT_EQ(*numbers.begin(), 1);
  EXPECT_EQ(*numbers.rbegin(), 40);
}

// A claim is given up by decision 0030 only: its table names each solver and case, and nothing else.
TEST(StabilityTable, GivesUpWhatTheDecisionSays) {
  const auto file = std::filesystem::path(GONIOLUX_SOURCE_DIR) / "docs" / "decisions" / "0030-claims-of-solvers.md";
  std::istringstream lines(core::readFile(file.string()));
  std::set<std::pair<std::string, int>> decided, given;
  for (std::string line; std::getline(lines, line);) {
    static const std::regex row(R"(\| ((?:`[a-z]+`(?:, )?)+) \| ([0-9, ]+) \|.*)");
    std::smatch parts;
    if (!std::regex_match(line, parts, row)) continue;
    static const std::regex name("`([a-z]+)`"), number("[0-9]+");
    const std::string solvers = parts[1], cases = parts[2];
    for (std::sregex_iterator s(solvers.begin(), solvers.end(), name), end; s != end; ++s)
      for (std::sregex_iterator c(cases.begin(), cases.end(), number); c != end; ++c)
        decided.emplace((*s)[1], std::stoi(c->str()));
  }
  for (const Case& one : readCases())
    for (const std::string& solver : solverNames())
      if (isWorse(one.claimOf(solver), Outcome::right)) given.emplace(solver, one.number);
  for (const auto& [solver, number] : given)
    EXPECT_TRUE(decided.contains({solver, number})) << solver << " gives up case " << number << " without a decision";
  for (const auto& [solver, number] : decided)
    EXPECT_TRUE(given.contains({solver, number}))
        << solver << " claims case " << number << ", which the decision gives up";
}

TEST(StabilityPage, ReadsBackAsWhatItWasWrittenFrom) {
  const std::vector<Case> cases = readCases();
  const std::vector<std::string> solvers = {"auto", "path"};
  Outcomes outcomes;
  for (const Case& one : cases)
    for (const std::string& solver : solvers) {
      CaseOutcome& outcome = outcomes[one.number][solver];
      outcome.outcome = one.number % 3 == 0   ? Outcome::tooSlow
                        : one.number % 2 == 0 ? Outcome::refused
                                              : Outcome::right;
      outcome.checks.resize(one.checks.size());
    }
  const std::string page = stabilityPage(cases, solvers, outcomes);
  const Record record = recordFrom(page);
  ASSERT_EQ(record.size(), cases.size());
  for (const auto& [number, row] : outcomes)
    for (const auto& [solver, outcome] : row) EXPECT_EQ(record.at(number).at(solver), outcome.outcome);
  // Some cases run anew: the others' entries stay.
  Outcomes some;
  some[7] = outcomes[7];
  some[7]["path"].outcome = Outcome::says;
  const std::string mended = stabilityPage(cases, solvers, some, page);
  EXPECT_EQ(recordFrom(mended).at(7).at("path"), Outcome::says);
  EXPECT_EQ(stabilityPage(cases, solvers, {{7, outcomes[7]}}, mended), page);
}

TEST(StabilityRecord, KnowsWhatIsWorse) {
  EXPECT_TRUE(isWorse(Outcome::wrong, Outcome::says));
  EXPECT_TRUE(isWorse(Outcome::wide, Outcome::right));
  EXPECT_FALSE(isWorse(Outcome::refused, Outcome::right));
  EXPECT_FALSE(isWorse(Outcome::right, Outcome::refused));
  EXPECT_FALSE(isWorse(Outcome::says, Outcome::wrong));
}

core::Estimate estimate(double value, double statistical, double systematic) {
  return {value, statistical, {{"all", systematic}}};
}

// Negative controls: what the judge must not let pass.
TEST(StabilityJudge, SeesWhatIsConfidentlyWrong) {
  EXPECT_EQ(judge({{100, estimate(100.5, 1, 0), 0, false}}, 0.95).outcome, Outcome::right);
  EXPECT_EQ(judge({{100, estimate(103, 1, 0), 0, false}}, 0.95).outcome, Outcome::wrong);
  EXPECT_EQ(judge({{100, estimate(103, 1, 1.5), 0, false}}, 0.95).outcome, Outcome::right);
  EXPECT_EQ(judge({{100, estimate(0, 0, 0), 0.01, false}}, 0.95).outcome, Outcome::wrong);
  EXPECT_EQ(judge({{0, estimate(0, 0, 0), 0, true}}, 0.95).outcome, Outcome::right);
  EXPECT_EQ(judge({{0, estimate(0, 1e-6, 0), 0, true}}, 0.95).outcome, Outcome::wrong);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(judge({{100, estimate(nan, 1, 0), 0, false}}, 0.95).outcome, Outcome::wrong);
  EXPECT_EQ(judge({{100, estimate(100, HUGE_VAL, 0), 0, false}}, 0.95).outcome, Outcome::wrong);
}

// One value in ten thousand checks: 16 replicates of a normal variable fall outside as often as is stated.
TEST(StabilityJudge, StretchesIntervalsToItsRateOfFalseAlarms) {
  // Student's t with 15 degrees of freedom: 95 % at 2.1314, 99.99 % at 5.2391 (Abramowitz and Stegun, table 26.10).
  EXPECT_EQ(judge({{100, estimate(100 + 0.99 * 5.2391 / 2.1314, 1, 0), 0, false}}, 0.95).outcome, Outcome::right);
  EXPECT_EQ(judge({{100, estimate(100 + 1.01 * 5.2391 / 2.1314, 1, 0), 0, false}}, 0.95).outcome, Outcome::wrong);
}

}  // namespace
}  // namespace goniolux::stability
