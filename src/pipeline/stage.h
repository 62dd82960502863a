// Stage: a step of the paper's plan as a function: it takes a request and a progress sink and returns a report. It
// reads and writes files, never prints and never exits. The command line and the interface both drive stages, so that
// both give the same.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "core/document.h"
#include "core/parameter.h"
#include "core/progress.h"

namespace goniolux::pipeline {

/// What every verb understands; unset means: as the project says.
struct CommonOptions {
  std::optional<std::string> output;    ///< -o: folder or file, as the stage says
  std::optional<std::string> accuracy;  ///< "1 %"
  std::optional<std::string> solver;
  std::optional<std::string> spectral;  ///< "SCHEME:N"
  std::optional<std::string> scene;     ///< lighting scene
  std::optional<std::uint64_t> seed;
  std::optional<double> timeLimit_s;
  std::vector<std::string> set;  ///< "KEY=VALUE", any settings key
};

struct StageRequest {
  std::vector<std::string> inputs;  ///< positional arguments
  CommonOptions common;
  std::map<std::string, std::string> options;   ///< the stage's own options by key, e.g. "view"
  std::optional<std::string> projectText = {};  ///< taken instead of the project file's: an unsaved document
  std::optional<double> keepEvery_s = {};       ///< how often finished work goes to disk; unset: as KeptWork does
};

struct StageReport {
  core::Value json;                ///< what --json prints (docs/interface)
  std::string text;                ///< what a person reads on a terminal
  std::vector<std::string> files;  ///< what was written
  core::Diagnostics warnings;
  bool verdictFailed = false;  ///< a requirement or verification failed: exit code 1
  bool inputFailed = false;    ///< some inputs could not be read, the others were done: exit code 2
  bool unfinished = false;     ///< interrupted, what was done is kept: exit code 3
};

struct Stage {
  std::string name, title, help;
  std::string inputName;  ///< "PROJECT", "FILE", "RESULTS", …; "" = takes none
  bool manyInputs = false;
  std::vector<core::Parameter> options;  ///< own options; key "view" is --view
  StageReport (*run)(const StageRequest& request, core::ProgressSink& progress);
};

/// One line per stage in stages.cpp; each is a verb of the command line and an action of the interface.
const std::vector<Stage>& stages();

}  // namespace goniolux::pipeline
