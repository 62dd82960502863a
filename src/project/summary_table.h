// SummaryTable: results as a spreadsheet takes them over, by file or clipboard.
#pragma once

#include <string>

#include "project/results.h"

namespace goniolux::project {

/// Tab-separated: a line per grid (mean, minimum, maximum, U0) and observer, each figure with its half-width and the
/// unit in its own column, then a line per requirement.
std::string toSummaryTable(const Results& results);

inline constexpr const char* summaryFileName = "summary.tsv";

}  // namespace goniolux::project
