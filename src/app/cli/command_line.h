// The command line as typed, turned into a request to one stage. Verbs and their own options come from the registry of
// stages.
#pragma once

#include <string>
#include <vector>

#include "pipeline/stage.h"

namespace goniolux::app {

struct CommandLine {
  enum class Action { runStage, printHelp, printVersion, printManual, printCompletion, printVerbs };
  Action action = Action::runStage;
  const pipeline::Stage* stage = nullptr;  ///< null: help about the whole program
  pipeline::StageRequest request;
  std::string shell;  ///< printCompletion: "bash", "zsh" or "fish"
  int threads = 0;    ///< 0 = as many as the machine has
  bool json = false, quiet = false;
};

/// Reads the arguments after the program's name. Throws core::InputError (rule "usage") that says what is wrong and
/// what to do.
CommandLine parseCommandLine(const std::vector<std::string>& arguments);

}  // namespace goniolux::app
