// Runs a case by a solver with the program itself: `goniolux illuminate`, `render` and `check` on its project files,
// one thread, with a limit of CPU time.
#pragma once

#include <string>
#include <vector>

#include "stability/case_table.h"
#include "stability/judge.h"

namespace goniolux::stability {

struct CaseOutcome {
  Outcome outcome = Outcome::right;  ///< the worst of the checks
  std::vector<Judgement> checks;     ///< in the order of the case's
  double cpuSeconds = 0;

  /// The check that decided, in words.
  [[nodiscard]] std::string detail(const Case& one) const;
};

CaseOutcome runCase(const Case& one, const std::string& solver);

}  // namespace goniolux::stability
