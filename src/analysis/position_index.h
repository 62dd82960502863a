// Guth's position index, which discounts glare sources away from the line of sight.
#pragma once

#include <optional>

#include "core/vector.h"

namespace goniolux::analysis {

/// `forward`: unit line of sight; `up`: unit, perpendicular to it; `toSource`: unit. The formula by Levin (IES, 1975),
/// which CIE 117 tabulates and interpolates: 1.22 where its table has 1.26. Only for sources above the line of sight
/// and in front.
double positionIndex(const core::Vec3& forward, const core::Vec3& up, const core::Vec3& toSource);

/// The same within the field of CIE 117's table: nothing for a source behind the eye, higher than 1.9 times its
/// distance R along the line of sight, or farther aside than 3 times. Below the line of sight, where that table is
/// silent: Iwata and Tokura (1997), 1 + 0.8 r for r = sqrt(H^2 + T^2)/R below 0.6, else 1 + 1.2 r.
std::optional<double> positionIndexInField(const core::Vec3& forward, const core::Vec3& up, const core::Vec3& toSource);

}  // namespace goniolux::analysis
