#include "app/cli/output.h"

#include <fmt/format.h>

#include <cstdio>
#include <new>

#include "core/document.h"

namespace goniolux::app {
namespace {

void printDiagnostics(const core::Diagnostics& diagnostics) {
  for (const core::Diagnostic& diagnostic : diagnostics.all()) fmt::print(stderr, "{}\n", core::toString(diagnostic));
}

core::Value toDocument(const core::Diagnostics& diagnostics) {
  core::Value::Array errors, warnings;
  for (const core::Diagnostic& diagnostic : diagnostics.all()) {
    core::Value entry;
    entry.set("file", diagnostic.position.file);
    entry.set("line", diagnostic.position.line);
    entry.set("column", diagnostic.position.column);
    entry.set("rule", diagnostic.rule);
    entry.set("message", diagnostic.message);
    (diagnostic.severity == core::Severity::error ? errors : warnings).push_back(entry);
  }
  core::Value document;
  document.set("errors", errors);
  document.set("warnings", warnings);
  return document;
}

core::Diagnostics asDiagnostics(const std::string& rule, const std::string& message) {
  core::Diagnostics diagnostics;
  diagnostics.error({"goniolux", 0, 0}, rule, message);
  return diagnostics;
}

ExitCode exitCodeOf(const pipeline::StageReport& report) {
  if (report.inputFailed) return exitBadInput;
  if (report.unfinished) return exitUnfinished;
  return report.verdictFailed ? exitVerdictFailed : exitDone;
}

}  // namespace

void printResult(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) throw core::RunError("cannot write to standard output; is the disk full?");
}

ExitCode printReport(const CommandLine& line, const pipeline::StageReport& report) {
  printDiagnostics(report.warnings);
  if (line.json) {
    printResult(core::toJson(report.json));
  } else if (!line.quiet) {
    std::string text = report.text;
    if (!text.empty() && !text.ends_with('\n')) text += '\n';
    for (const std::string& file : report.files) text += "wrote " + file + '\n';
    printResult(text);
  }
  return exitCodeOf(report);
}

ExitCode printFailure(bool json, const std::exception& failure) {
  core::Diagnostics diagnostics;
  ExitCode code = exitUnfinished;
  if (const auto* input = dynamic_cast<const core::InputError*>(&failure)) {
    diagnostics = input->diagnostics();
    code = exitBadInput;
  } else if (dynamic_cast<const core::RunError*>(&failure) != nullptr) {
    diagnostics = asDiagnostics("unfinished", failure.what());
  } else if (dynamic_cast<const std::bad_alloc*>(&failure) != nullptr) {
    diagnostics =
        asDiagnostics("out-of-memory", "not enough memory for this job; ask for fewer points, pixels or threads");
  } else {
    diagnostics = asDiagnostics(
        "internal",
        fmt::format("internal error: {}; please report it with the project and the command line", failure.what()));
  }
  printDiagnostics(diagnostics);
  if (json) printResult(core::toJson(toDocument(diagnostics)));
  return code;
}

}  // namespace goniolux::app
