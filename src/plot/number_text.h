// How numbers are written in pictures.
#pragma once

#include <string>

namespace goniolux::plot {

/// A value as it is written beside a line or a scale: four significant digits, no exponent below a million.
std::string levelText(double value);

/// A value of a map as it is written at its point: whole numbers from 100 on, three significant digits below.
std::string pointText(double value);

/// "512 ± 4" and "0.563 ± 0.012": the half-width with one significant digit (two where the first is 1), the value to
/// the same place.
std::string uncertaintyText(double value, double halfWidth);

}  // namespace goniolux::plot
