// `goniolux luminaire convert IN OUT` and `goniolux luminaire compare A B`.
#pragma once

#include "core/diagnostics.h"
#include "photometry/photometric_file.h"
#include "pipeline/stage.h"

namespace goniolux::pipeline {

/// Reads IN, turns it about its aim by `turnDegrees`, writes OUT in the format that its ending asks for, reads it back
/// and says what became of the candelas. The file is not written when it cannot be.
StageReport convertLuminaire(const std::string& in, const std::string& out, double turnDegrees,
                             photometry::Strictness strictness);

/// Fluxes, peaks, openings, and how far the intensities are apart; also with B turned by quarters, because formats and
/// makers differ about where C0 lies.
StageReport compareLuminaires(const std::string& a, const std::string& b, photometry::Strictness strictness);

}  // namespace goniolux::pipeline
