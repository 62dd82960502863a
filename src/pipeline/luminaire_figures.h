// Pictures of a photometric file: polar and Cartesian diagram, photometric solid, and the error of the point model over
// distance. Drawn by the helper program.
#pragma once

#include <string>

#include "core/diagnostics.h"
#include "photometry/photometric_file.h"
#include "plot/line_chart.h"
#include "plot/photometric_solid.h"

namespace goniolux::pipeline {

/// Intensity over gamma in the planes that the symmetry leaves apart, at most four.
plot::LineChart cartesianDiagramOf(const photometry::PhotometricFile& file);
/// The whole distribution, five degrees or finer.
plot::PhotometricSolid photometricSolidOf(const photometry::PhotometricFile& file);
/// Error of the illuminance along the aim over distance: the opening as one point, 2 x 2 and 4 x 4. Refuses
/// (InputError) a file without an opening, or without light along the aim.
plot::LineChart nearFieldChartOf(const photometry::PhotometricFile& file);

/// Draws `kind` (polar, cartesian, solid, near-field) into `picture` (.png or .svg). Where drawing is not possible
/// `warnings` says why. True if the picture is there. Throws core::InputError if the kind or the file's ending is none,
/// core::RunError where the disk says no.
bool drawLuminaire(const photometry::PhotometricFile& file, const std::string& kind, const std::string& picture,
                   core::Diagnostics& warnings);

}  // namespace goniolux::pipeline
