#include "plot/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace goniolux::plot {

std::string levelText(double value) {
  if (value == 0) return "0";
  std::string text = fmt::format("{:.4g}", value);
  if (text.find('e') != std::string::npos && std::abs(value) >= 1 && std::abs(value) < 1e6) {
    text = fmt::format("{:.0f}", value);
  }
  return text;
}

std::string pointText(double value) {
  return std::abs(value) >= 99.95 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

std::string uncertaintyText(double value, double halfWidth) {
  if (!std::isfinite(value)) return "undefined";
  if (!(halfWidth > 0) || !std::isfinite(halfWidth)) return levelText(value);
  const double power = std::floor(std::log10(halfWidth));
  const bool firstIsOne = halfWidth / std::pow(10.0, power) < 1.95;
  const int decimals = std::clamp(static_cast<int>(firstIsOne ? 1 - power : -power), 0, 9);
  return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, halfWidth, decimals);
}

}  // namespace goniolux::plot
