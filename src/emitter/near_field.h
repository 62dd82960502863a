// How wrong a luminaire is when its opening is taken as one point, or cut into a few: the "five-times rule", measured.
#pragma once

#include <optional>
#include <vector>

#include "emitter/emitter.h"

namespace goniolux::emitter {

/// The places of n x n points of equal flux over the opening's length and width, or over its disc, relative to its
/// centre, in the world. n = 1: the centre.
std::vector<core::Vec3> cutPlaces(const Opening& opening, const photometry::LuminaireFrame& frame, int n);

/// Relative error of the illuminance at `distance` along the aim from the opening's centre, on a plane facing it, when
/// the opening is replaced by the points of cutPlaces(). Nothing where the opening sends no light that way. The
/// reference is the opening's closed form or quadrature.
std::optional<double> cutError(const Opening& opening, const Output& output, double distance, int n);

/// The largest extent of an opening, m; 0 for a point.
double largestExtent(const Opening& opening);

/// The distance along the aim from which on the point model stays within `error`; between a tenth of and a hundred
/// times the largest extent. Nothing for a point, or where no light goes along the aim.
std::optional<double> pointModelFrom(const Opening& opening, const Output& output, double error);

}  // namespace goniolux::emitter
