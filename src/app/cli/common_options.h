// The options that several verbs share, described like a stage's own so that --help and the reading of the command line
// use one table.
#pragma once

#include <vector>

#include "pipeline/stage.h"

namespace goniolux::app {

struct CommonOption {
  core::Parameter parameter;  ///< key "time-limit" is --time-limit
  char letter = 0;            ///< short form; 0 = none
  bool isFlag = false;        ///< takes no value
  bool needsProject = false;  ///< steers a calculation: only for verbs that read a project
};

const std::vector<CommonOption>& commonOptions();

/// Whether the verb of `stage` understands `option`.
bool applies(const CommonOption& option, const pipeline::Stage& stage);

}  // namespace goniolux::app
