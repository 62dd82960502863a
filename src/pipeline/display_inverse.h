// `display --inverse`: from code values back to the light that a device gives for them.
#pragma once

#include "display/device.h"
#include "pipeline/stage.h"

namespace goniolux::pipeline {

/// Reads a picture (PNG, TIFF, DPX; -o NAME.exr takes its X, Y, Z) or a list of patches (text; a table).
StageReport inverseReport(const StageRequest& request, const display::Device& device);

}  // namespace goniolux::pipeline
