#include "pipeline/flux_bands.h"

#include <vector>

#include "spectrum/cie_data.h"

namespace goniolux::pipeline {
namespace {

using spectrum::SpectralDistribution;

constexpr double from = 360, to = 830;

double luminous(const SpectralDistribution& source, double low, double high) {
  return source.integral(spectrum::cie1931().ybar, low, high);
}

}  // namespace

FluxBands::FluxBands(const SpectralDistribution& source) : source_(source) {
  const double whole = luminous(source, from, to);
  edges_ = {from, from, from, to};
  for (int band = 1; band < 3; ++band) {
    double low = from, high = to;
    for (int step = 0; step < 50; ++step) {
      const double middle = 0.5 * (low + high);
      (luminous(source, from, middle) < whole * band / 3 ? low : high) = middle;
    }
    edges_[static_cast<std::size_t>(band)] = high;
  }
}

FluxBands::Three FluxBands::mean(const SpectralDistribution& reflectance) const {
  Three result{};
  const SpectralDistribution& v = spectrum::cie1931().ybar;
  for (std::size_t band = 0; band < 3; ++band) {
    double sum = 0, weight = 0;
    const auto add = [&](double wavelength, double power) {
      weight += power * v.continuum(wavelength);
      sum += power * v.continuum(wavelength) * reflectance.continuum(wavelength);
    };
    constexpr int steps = 200;
    const double width = (edges_[band + 1] - edges_[band]) / steps;
    for (int k = 0; k < steps; ++k) {
      const double wavelength = edges_[band] + (k + 0.5) * width;
      add(wavelength, source_.continuum(wavelength) * width);
    }
    for (const SpectralDistribution::Line& line : source_.lines())
      if (line.wavelength > edges_[band] && line.wavelength <= edges_[band + 1]) add(line.wavelength, line.power);
    result[band] = weight > 0 ? sum / weight : 0;
  }
  return result;
}

FluxBands::Three FluxBands::shares(const SpectralDistribution& source) const {
  const double whole = luminous(source, from, to);
  Three result{};
  for (std::size_t band = 0; band < 3; ++band)
    result[band] = whole > 0 ? luminous(source, edges_[band], edges_[band + 1]) / whole : 1.0 / 3;
  return result;
}

}  // namespace goniolux::pipeline
