// Every case of the suite is within its tolerance, and docs/validation.md says what was calculated.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "core/document.h"
#include "core/parallel.h"
#include "support/temporary_folder.h"
#include "validation/page.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

namespace fs = std::filesystem;

// GONIOLUX_VALIDATION_CASES="1.2 3.5A": only these; the page, where it is written anew, keeps the others.
bool isAsked(const std::string& id) {
  const char* asked = std::getenv("GONIOLUX_VALIDATION_CASES");
  return asked == nullptr || (" " + std::string(asked) + " ").find(" " + id + " ") != std::string::npos;
}

bool inFull() {
  return std::getenv("GONIOLUX_VALIDATION_FULL") != nullptr;
}

// Calculated once, for its own test and for the page.
const std::vector<Number>& numbersOf(const Case& of) {
  static std::map<std::string, std::vector<Number>> known;
  const auto found = known.find(of.id);
  if (found != known.end()) return found->second;
  const double before = core::processCpuSeconds();
  std::vector<Number> calculated;
  try {
    calculated = of.calculate();
  } catch (const std::exception& error) {
    ADD_FAILURE() << of.id << ": " << error.what();
  }
  auto& numbers = known[of.id] = std::move(calculated);
  std::fflush(stdout);
  std::printf("%-6s %-45s %3zu numbers, %.2f CPU s\n", of.id.c_str(), of.title.c_str(), numbers.size(),
              core::processCpuSeconds() - before);
  return numbers;
}

// All sections in one test program run: CTest starts a process per test, and the page needs every case.
TEST(Validation, EveryCaseIsRightAndThePageSaysSo) {
  const fs::path page = fs::path(GONIOLUX_SOURCE_DIR) / "docs/validation.md";
  const std::string written = fs::exists(page) ? test::contentOf(page) : "";
  const bool update = std::getenv("GONIOLUX_UPDATE_PAGES") != nullptr;
  std::vector<std::vector<PagePart>> parts;
  std::set<std::string> ids;
  std::size_t cases = 0, numbers = 0;
  for (const Section& section : sections()) {
    parts.emplace_back();
    for (const Case& each : section.cases) {
      EXPECT_TRUE(ids.insert(each.id).second) << each.id << " is there twice";
      if (!isAsked(each.id) || (each.takesMinutes && !inFull())) {
        PagePart kept = partFrom(written, each.id);
        if (kept.table.empty()) kept = partNotCalculated(each);
        parts.back().push_back(std::move(kept));
        continue;
      }
      const auto& found = numbersOf(each);
      const Verdict verdict = verdictOf(found, each);
      EXPECT_EQ(verdict.passed(), each.knownDefect.empty())
          << each.id << ' ' << each.title << ": " << verdict.wrong << " wrong, " << verdict.outside
          << " outside their intervals\n"
          << partOf(each, found).table;
      parts.back().push_back(partOf(each, found));
      ++cases;
      numbers += found.size();
    }
  }
  std::printf("%zu cases, %zu numbers\n", cases, numbers);
  if (std::getenv("GONIOLUX_VALIDATION_CASES") != nullptr && !update) {
    for (const auto& section : parts)
      for (const PagePart& part : section)
        if (isAsked(part.id)) std::printf("%s\n", part.table.c_str());
    return;
  }
  const std::string calculated = validationPage(sections(), parts);
  core::writeFile((fs::path(GONIOLUX_BINARY_DIR) / "validation.md").string(), calculated);
  if (update) {
    core::writeFile(page.string(), calculated);
    GTEST_SKIP() << "docs/validation.md was written anew";
  }
  EXPECT_EQ(firstDifference(calculated, written), "") << "write it anew: GONIOLUX_UPDATE_PAGES=1 script/validation";
}

// What the suite relies on: its verdicts can be bad, and the page's comparison can find a difference.
TEST(ValidationVerdict, IsWrongWhereANumberIs) {
  Case exact;
  exact.tolerance = 0.001;
  EXPECT_EQ(verdictOf(Number{"", 100, 100.09, 0, 0}, exact), NumberVerdict::right);
  EXPECT_EQ(verdictOf(Number{"", 100, 100.11, 0, 0}, exact), NumberVerdict::wrong);
  EXPECT_EQ(verdictOf(Number{"", 100, 100.11, 0, 0.05}, exact), NumberVerdict::right);
  Case chance;
  chance.tolerance = 0.01;
  EXPECT_EQ(verdictOf(Number{"", 100, 100.4, 0.5, 0}, chance), NumberVerdict::right);
  EXPECT_EQ(verdictOf(Number{"", 100, 100.8, 0.5, 0}, chance), NumberVerdict::outside);
  EXPECT_EQ(verdictOf(Number{"", 100, 101.1, 0.5, 0}, chance), NumberVerdict::wrong);
  EXPECT_EQ(verdictOf(Number{"", 100, 100, 1.1, 0}, chance), NumberVerdict::wrong);  // too wide to say anything
  EXPECT_EQ(verdictOf(Number{"", 100, std::nan(""), 0.5, 0}, chance), NumberVerdict::wrong);
  // Of two numbers one may be outside; of two, two may not.
  const Number right{"", 100, 100, 0.5, 0}, outside{"", 100, 100.8, 0.5, 0};
  EXPECT_TRUE(verdictOf({right, outside}, chance).passed());
  EXPECT_FALSE(verdictOf({outside, outside}, chance).passed());
  EXPECT_FALSE(verdictOf(std::vector<Number>{}, chance).passed());
}

TEST(ValidationPage, DiffersWhereANumberMovedBeyondItsInterval) {
  Case of{"9.9", "a case", "lx", "scene", "source", "", 0.01, 0, false, {}};
  Section section{"title", "introduction", {of}};
  const auto page = [&](double ours, double halfWidth) {
    return validationPage({section}, {{partOf(of, {{"A", 100, ours, halfWidth, 0}})}});
  };
  EXPECT_EQ(firstDifference(page(100.2, 0.5), page(100.2, 0.5)), "");
  EXPECT_EQ(firstDifference(page(100.2, 0.5), page(99.8, 0.4)), "");
  EXPECT_NE(firstDifference(page(100.2, 0.1), page(99.8, 0.1)), "");
  EXPECT_NE(firstDifference(page(100.2, 0), page(100.3, 0)), "");
  EXPECT_NE(firstDifference(page(100.2, 0.5), page(100.2, 0.5) + "more\n"), "");
  EXPECT_EQ(partFrom(page(100.2, 0.5), "9.9").table, partOf(of, {{"A", 100, 100.2, 0.5, 0}}).table);
  EXPECT_EQ(partFrom(page(100.2, 0.5), "9.8").table, "");
}

}  // namespace
}  // namespace goniolux::validation
