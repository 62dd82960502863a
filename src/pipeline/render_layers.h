// Views as layers: an image per luminaire group at full level, kept, and their sum for any dimming.
#pragma once

#include <vector>

#include "pipeline/render.h"

namespace goniolux::pipeline {

/// For each view and each group layers/GROUP/NAME.exr (and layers/emitting-surfaces where surfaces emit), taken as it
/// is where it was made from the same inputs, else rendered; then NAME.exr, the sum at the project's dimming.
/// InputError when the luminaires of a group are dimmed differently.
StageReport renderLayers(const project::Project& project, const std::vector<const scene::View*>& views,
                         const std::string& folder, const RenderOptions& options, core::ProgressSink& progress);

}  // namespace goniolux::pipeline
