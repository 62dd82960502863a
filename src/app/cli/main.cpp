// goniolux: the command line. It reads its arguments, runs one stage and prints the report; nothing is computed here.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "app/cli/command_line.h"
#include "app/cli/completion.h"
#include "app/cli/help.h"
#include "app/cli/interrupt.h"
#include "app/cli/manual.h"
#include "app/cli/output.h"
#include "app/cli/terminal_progress.h"
#include "core/parallel.h"

namespace {

using namespace goniolux;
using app::CommandLine;

int runStage(const CommandLine& line) {
  core::setThreadCount(line.threads);
  app::TerminalProgress progress(line.quiet);
  const app::InterruptGuard guard(progress);
  const pipeline::StageReport report = line.stage->run(line.request, progress);
  progress.clear();
  return app::printReport(line, report);
}

int run(const std::vector<std::string>& arguments) {
  const CommandLine line = app::parseCommandLine(arguments);
  switch (line.action) {
    case CommandLine::Action::printHelp:
      app::printResult(line.stage == nullptr ? app::programHelp() : app::verbHelp(*line.stage));
      return app::exitDone;
    case CommandLine::Action::printVersion:
      app::printResult("goniolux " GONIOLUX_VERSION "\n");
      return app::exitDone;
    case CommandLine::Action::printManual:
      app::printResult(line.stage == nullptr ? app::programManual() : app::verbManual(*line.stage));
      return app::exitDone;
    case CommandLine::Action::printCompletion:
      app::printResult(app::completionFor(line.shell));
      return app::exitDone;
    case CommandLine::Action::printVerbs:
      for (const pipeline::Stage& stage : pipeline::stages()) app::printResult(stage.name + "\n");
      return app::exitDone;
    case CommandLine::Action::runStage:
      break;
  }
  return runStage(line);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  // Known before the arguments are understood: a usage error, too, is one document for who asked for one.
  const bool json = std::find(arguments.begin(), arguments.end(), "--json") != arguments.end();
  try {
    return run(arguments);
  } catch (const std::exception& failure) {
    try {
      return app::printFailure(json, failure);
    } catch (const std::exception& second) {
      fmt::print(stderr, "goniolux: error: {}\n", second.what());
      return app::exitUnfinished;
    }
  }
}
