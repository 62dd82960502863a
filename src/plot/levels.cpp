#include "plot/levels.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

namespace goniolux::plot {
namespace {

// EN 12464-1:2021, 5.3.1: the scale of illuminance; a step is the smallest difference that people notice (a factor of
// about 1.5).
constexpr double illuminanceScale[] = {5,   7.5, 10,  15,   20,   30,   50,   75,   100,  150,  200,
                                       300, 500, 750, 1000, 1500, 2000, 3000, 5000, 7500, 10000};

/// 1, 2, 2.5 or 5 times a power of ten, next to `rough`.
double roundStep(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double lead = rough / power;
  const double nice = lead < 1.4 ? 1 : lead < 2.2 ? 2 : lead < 3.4 ? 2.5 : lead < 7 ? 5 : 10;
  return nice * power;
}

std::vector<double> multiples(double minimum, double maximum, double step, bool endsIncluded) {
  std::vector<double> list;
  const double slack = 1e-9 * step;
  for (double k = std::ceil(minimum / step - 1e-9); k * step <= maximum + slack; ++k) {
    const double value = k * step;
    const bool inside = value > minimum + slack && value < maximum - slack;
    if (inside || endsIncluded) list.push_back(value == 0 ? 0.0 : value);
  }
  return list;
}

}  // namespace

std::vector<double> isoluxLevels(double minimum, double maximum, double finest) {
  if (!(maximum - minimum > 1e-6 * std::abs(maximum)) || !std::isfinite(maximum - minimum)) return {};
  if (maximum - minimum < 2 * finest) return {};
  std::vector<double> levels;
  for (const double step : illuminanceScale) {
    if (step > minimum && step < maximum) levels.push_back(step);
  }
  if (levels.size() >= 5 && maximum <= 12000) return levels;
  double step = roundStep((maximum - minimum) / 6.5);
  while (step < finest) step = roundStep(2 * step);
  return multiples(minimum, maximum, step, false);
}

std::vector<double> mapLevels(std::vector<double> values, double finest) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double fraction) {
    return values[static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1))];
  };
  const double minimum = values.front(), maximum = values.back();
  std::vector<double> levels = isoluxLevels(quantile(0.05), quantile(0.98), finest);
  if (levels.empty()) return isoluxLevels(minimum, maximum, finest);
  for (int extra = 0; extra < 2; ++extra) {
    const auto above = std::upper_bound(std::begin(illuminanceScale), std::end(illuminanceScale), levels.front() / 2);
    if (above == std::begin(illuminanceScale) || *(above - 1) <= minimum) break;
    levels.insert(levels.begin(), *(above - 1));
  }
  for (int extra = 0; extra < 2; ++extra) {
    const auto above = std::lower_bound(std::begin(illuminanceScale), std::end(illuminanceScale), 2 * levels.back());
    if (above == std::end(illuminanceScale) || *above >= maximum) break;
    levels.push_back(*above);
  }
  return levels;
}

std::vector<double> axisTicks(double minimum, double maximum, int wanted) {
  if (!(maximum > minimum) || !std::isfinite(maximum - minimum)) return {};
  return multiples(minimum, maximum, roundStep((maximum - minimum) / wanted), true);
}

std::optional<std::vector<double>> parseLevels(const std::string& text) {
  std::vector<double> levels;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    while (at < end && (*at == ' ' || *at == ',' || *at == ';')) ++at;
    if (at == end) break;
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    if (next < end && *next != ' ' && *next != ',' && *next != ';') return std::nullopt;
    levels.push_back(value);
    at = next;
  }
  if (levels.empty()) return std::nullopt;
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

}  // namespace goniolux::plot
