// Guth's position index, which discounts glare sources away from the line of sight.
#pragma once

#include "core/vector.h"

namespace goniolux::analysis {

/// `forward`: unit line of sight; `up`: unit, perpendicular to it; `toSource`: unit. The formula by Levin (IES, 1975),
/// which CIE 117 tabulates and interpolates: 1.22 where its table has 1.26. Only for sources above the line of sight
/// and in front.
double positionIndex(const core::Vec3& forward, const core::Vec3& up, const core::Vec3& toSource);

}  // namespace goniolux::analysis
