// The table of the stability suite, tests/stability/cases.json: what each case checks, and what each solver claims.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/document.h"

namespace goniolux::stability {

/// How a solver fares in a case, best first: each is worse than those before it.
enum class Outcome {
  right,     ///< every figure within its interval, to the accuracy asked for; what has no answer is refused
  refused,   ///< nothing is calculated because there is no answer, and the message says so: as good as right
  wide,      ///< within their intervals, but those are wider than asked for
  says,      ///< a figure is off, and the results name what they left out
  declined,  ///< nothing is calculated although there is an answer
  tooSlow,
  wrong,  ///< confidently
  crashed,
};

const char* wordFor(Outcome outcome);
/// Throws std::runtime_error for a word that is none.
Outcome outcomeFrom(const std::string& word);
/// right and refused are equally good; else the order of the enumeration.
bool isWorse(Outcome one, Outcome than);

struct Check {
  std::string kind, what, project, source;
  core::Value row;  ///< all of it

  [[nodiscard]] double number(const char* key) const;
  [[nodiscard]] std::string text(const char* key) const;
  [[nodiscard]] bool flag(const char* key) const;
};

struct Case {
  int number = 0;
  std::string folder, title, breaks;
  std::string says;                       ///< expression that a sentence of "left_out" must match
  std::map<std::string, Outcome> claims;  ///< by solver; "*" for those that are not named
  /// What falls short of its claim and is known to: by solver ("*": all others) the outcome, and why.
  std::map<std::string, std::pair<Outcome, std::string>> openDefects;
  bool fast = false;
  double seconds = 0;  ///< CPU time that one run of the program may take
  std::vector<Check> checks;

  [[nodiscard]] Outcome claimOf(const std::string& solver) const;
  /// The solver's open defect, or null.
  [[nodiscard]] const std::pair<Outcome, std::string>* openDefectOf(const std::string& solver) const;
};

std::filesystem::path casesFolder();
/// Throws std::runtime_error where the table is not what it should be.
std::vector<Case> readCases();

/// The solvers of the registry, and "auto" before them.
std::vector<std::string> solverNames();

}  // namespace goniolux::stability
