// What the program says: results on standard output, everything else on standard error.
#pragma once

#include <exception>
#include <string>

#include "app/cli/command_line.h"
#include "core/diagnostics.h"
#include "pipeline/stage.h"

namespace goniolux::app {

enum ExitCode : int { exitDone = 0, exitVerdictFailed = 1, exitBadInput = 2, exitUnfinished = 3 };

/// Writes text to standard output; RunError when it cannot be written (a full disk, a closed pipe).
void printResult(const std::string& text);

/// Prints a stage's report and says which exit code it means.
ExitCode printReport(const CommandLine& line, const pipeline::StageReport& report);

/// Prints what went wrong, to standard error and, with --json, as a document with "errors" and "warnings"; says the
/// exit code.
ExitCode printFailure(bool json, const std::exception& failure);

}  // namespace goniolux::app
