// docs/stability.md: the outcome of every case by every solver, and what each case is about. Written by the full suite
// (script/stability), and read back as what no entry may fall behind.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "stability/case_table.h"
#include "stability/run_case.h"

namespace goniolux::stability {

/// By case number and solver.
using Outcomes = std::map<int, std::map<std::string, CaseOutcome>>;
using Record = std::map<int, std::map<std::string, Outcome>>;

std::filesystem::path pageFile();
/// `before`: an earlier page, whose entries stay for the cases that have no outcome.
std::string stabilityPage(const std::vector<Case>& cases, const std::vector<std::string>& solvers,
                          const Outcomes& outcomes, const std::string& before = "");
/// The table of a page. Throws std::runtime_error where it cannot be read.
Record recordFrom(const std::string& page);

}  // namespace goniolux::stability
