// The polar diagram of a luminaire's photometric file, drawn by the helper program.
#pragma once

#include <string>

#include "core/diagnostics.h"
#include "photometry/photometric_file.h"
#include "plot/polar.h"

namespace goniolux::pipeline {

/// Intensities of the planes C0–C180 and C90–C270 (only the first where the distribution is rotational), as the file
/// gives them.
plot::PolarDiagram polarDiagramOf(const photometry::PhotometricFile& file);

/// Draws it into `picture` (.png or .svg). Where drawing is not possible `warnings` says why. True if the picture is
/// there. Throws core::InputError if the file's name ends otherwise, core::RunError where the disk says no.
bool drawPolarDiagram(const photometry::PhotometricFile& file, const std::string& picture, core::Diagnostics& warnings);

}  // namespace goniolux::pipeline
