// The help texts, written from the registry of stages and the table of common options.
#pragma once

#include <string>
#include <vector>

#include "pipeline/stage.h"

namespace goniolux::app {

/// An option as the help lists it: "-o, --output PATH" and what it does.
struct HelpRow {
  std::string name, text;
};
/// The verb's own options.
std::vector<HelpRow> ownOptionRows(const pipeline::Stage& stage);
/// Those that it shares with other verbs.
std::vector<HelpRow> commonOptionRows(const pipeline::Stage& stage);

std::string programHelp();
std::string verbHelp(const pipeline::Stage& stage);

}  // namespace goniolux::app
