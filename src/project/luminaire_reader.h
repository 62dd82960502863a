// The section "luminaires" of a project.
#pragma once

#include "core/document.h"
#include "photometry/intensity_distribution.h"
#include "project/reading.h"
#include "scene/environment.h"

namespace goniolux::project {

/// Adds every luminaire (each element of an array is one) and the distinct source spectra to the environment.
void readLuminaires(const core::Value& section, scene::Environment& environment, Reading& reading);

/// The frame of a luminaire that aims along the unit vector `aim`, with C0 in the direction of `c0` made perpendicular
/// to it (c0 must not be parallel to aim), turned by `turn` radians about aim, right-handed.
photometry::LuminaireFrame frameOf(const core::Vec3& aim, const core::Vec3& c0, double turn);

}  // namespace goniolux::project
