// The polar diagram of a luminaire's photometric file.
#pragma once

#include <string>

#include "photometry/photometric_file.h"
#include "plot/polar.h"

namespace goniolux::pipeline {

/// Intensities of the planes C0–C180 and C90–C270 (only the first where the distribution is rotational), as the file
/// gives them.
plot::PolarDiagram polarDiagramOf(const photometry::PhotometricFile& file);

}  // namespace goniolux::pipeline
