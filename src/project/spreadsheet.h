// Spreadsheet: results as an OpenDocument spreadsheet (.ods), which LibreOffice, Excel and Numbers open. Numbers are
// numbers with all their digits, shown with as many decimals as their half-widths deserve; units stand in the headers.
// Source: OpenDocument 1.2 (ISO/IEC 26300:2015), parts 1 (content) and 3 (package).
#pragma once

#include <string>

#include "project/results.h"

namespace goniolux::project {

/// Sheets: "Summary" (grids, observers, requirements with their verdicts), two per regular grid (its points in a list;
/// its values as they lie in the plane, v upward), one per list of points, and "How it was made". Same results, same
/// bytes.
std::string toSpreadsheet(const Results& results);

}  // namespace goniolux::project
