// The help texts, written from the registry of stages and the table of common options.
#pragma once

#include <string>

#include "pipeline/stage.h"

namespace goniolux::app {

std::string programHelp();
std::string verbHelp(const pipeline::Stage& stage);

}  // namespace goniolux::app
