// What a case's figures are worth: references against results.
//
// A figure is right when it lies within what chance explains of the reference: its systematic bounds, its statistical
// half-width stretched from the run's confidence to a rate of false alarms of 1e-4 for all values of a check together
// (Student's t with the 15 degrees of freedom of 16 replicates, Bonferroni), and how well the reference is known.
#pragma once

#include <string>
#include <vector>

#include "core/estimate.h"
#include "project/results.h"
#include "stability/case_table.h"

namespace goniolux::stability {

struct Judgement {
  Outcome outcome = Outcome::right;
  std::string detail;  ///< the figure that stands out most, in words
};

/// One figure of several in a check.
struct Figure {
  double reference = 0;
  core::Estimate found;
  double known = 0;  ///< how far the reference may be off
  bool exact = false;
};

/// right or wrong, by all figures of a check. What is not a finite number is wrong; an exact figure must be equal.
Judgement judge(const std::vector<Figure>& figures, double confidence);

/// The check of kind "points" or "weighted" in the results; a point without a value is wrong.
Judgement judgeGrid(const Check& check, const project::Results& results);

/// "same": the two results' grids agree, bit for bit where that is asked.
Judgement judgeSame(const Check& check, const project::Results& one, const project::Results& other);

/// "finite": the observer has a number with a half-width, or a stated reason for none.
Judgement judgeFinite(const Check& check, const project::Results& results);

}  // namespace goniolux::stability
