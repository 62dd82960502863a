// Levels: at which values isolines are drawn, and which values a scale names.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace goniolux::plot {

/// Isolux levels for a map whose values run from `minimum` to `maximum`: the steps of illuminance of EN 12464-1 (… 100,
/// 150, 200, 300, 500, 750, 1000 …) where at least five of them fall inside, otherwise even steps of 1, 2, 2.5 or 5
/// times a power of ten, about six of them and never closer than `finest` (what the values are certain to). Ascending,
/// strictly inside the range; empty for a map of one value.
std::vector<double> isoluxLevels(double minimum, double maximum, double finest = 0);

/// Levels for a map of these values. A few deep shadows or hot spots must not take the scale from the rest: the levels
/// of isoluxLevels() for what lies between the 5 % and the 98 % quantile, and outside that at most two further steps of
/// the scale of illuminance on each side, at least a factor of two apart.
std::vector<double> mapLevels(std::vector<double> values, double finest);

/// Even round numbers that cover [minimum, maximum] in about `wanted` steps, for axes. Ascending, inside the range.
std::vector<double> axisTicks(double minimum, double maximum, int wanted);

/// The list that a user wrote: "100, 200 300" gives 100, 200, 300; ascending, repeated values once. Nothing if it is no
/// such list.
std::optional<std::vector<double>> parseLevels(const std::string& text);

}  // namespace goniolux::plot
