// Manual pages (roff, man macros) from the same tables as --help.
#pragma once

#include <string>

#include "pipeline/stage.h"

namespace goniolux::app {

/// goniolux(1): the verbs.
std::string programManual();
/// goniolux-VERB(1).
std::string verbManual(const pipeline::Stage& stage);

}  // namespace goniolux::app
