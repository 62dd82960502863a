#include "planner/spectral_error.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "spectrum/colour_difference.h"

namespace goniolux::planner {
namespace {

using spectrum::SpectralDistribution;
using spectrum::Xyz;

constexpr int first = 360, last = 830, count = last - first + 1;
using Table = std::array<double, count>;

Table tabulated(const SpectralDistribution& distribution) {
  Table table;
  for (int i = 0; i < count; ++i) table[static_cast<std::size_t>(i)] = distribution.continuum(first + i);
  return table;
}

// Source times observer at 1 nm, lines put where they are by sharing them between the two nearest nanometres.
struct SourceTable {
  Table x{}, y{}, z{};
  explicit SourceTable(const SpectralDistribution& source) {
    const spectrum::Observer& observer = spectrum::cie1931();
    Table power = tabulated(source);
    for (const auto& line : source.lines()) {
      const double place = line.wavelength - first;
      const auto low = static_cast<int>(std::floor(place));
      if (low < 0 || low + 1 >= count) continue;
      power[static_cast<std::size_t>(low)] += line.power * (low + 1 - place);
      power[static_cast<std::size_t>(low) + 1] += line.power * (place - low);
    }
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double nm = first + static_cast<double>(i);
      x[i] = power[i] * observer.xbar.continuum(nm);
      y[i] = power[i] * observer.ybar.continuum(nm);
      z[i] = power[i] * observer.zbar.continuum(nm);
      sum += y[i];
    }
    for (std::size_t i = 0; i < count; ++i) x[i] /= sum, y[i] /= sum, z[i] /= sum;
  }
  [[nodiscard]] Xyz of(const Table& path) const {
    Xyz sum;
    for (std::size_t i = 0; i < count; ++i) sum.X += x[i] * path[i], sum.Y += y[i] * path[i], sum.Z += z[i] * path[i];
    return sum;
  }
};

}  // namespace

SpectralError spectralError(const spectrum::SpectralQuadrature& quadrature,
                            const std::vector<SpectralDistribution>& sources,
                            const std::vector<SpectralDistribution>& reflectances) {
  std::vector<Table> fine;
  std::vector<std::vector<double>> coarse;
  for (const SpectralDistribution& reflectance : reflectances) {
    fine.push_back(tabulated(reflectance));
    coarse.push_back(spectrum::atNodes(reflectance, quadrature));
  }
  SpectralError worst;
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const SourceTable source(sources[s]);
    Table ones;
    ones.fill(1);
    const Xyz white = source.of(ones);
    const auto compare = [&](const Table& truth, const std::vector<double>& nodes) {
      const Xyz exact = source.of(truth);
      Xyz approximate;
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const spectrum::Response& w = quadrature.weights[s][k];
        approximate.X += w[0] * nodes[k], approximate.Y += w[1] * nodes[k], approximate.Z += w[2] * nodes[k];
      }
      worst.luminance = std::max(worst.luminance, std::abs(approximate.Y - exact.Y) / white.Y);
      worst.colour =
          std::max(worst.colour, spectrum::deltaE2000(spectrum::lab(approximate, white), spectrum::lab(exact, white)));
    };
    for (std::size_t a = 0; a < fine.size(); ++a) {
      compare(fine[a], coarse[a]);
      for (std::size_t b = a; b < fine.size(); ++b) {
        Table product = fine[a];
        std::vector<double> nodes = coarse[a];
        for (std::size_t i = 0; i < count; ++i) product[i] *= fine[b][i];
        for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] *= coarse[b][k];
        compare(product, nodes);
      }
    }
  }
  return worst;
}

}  // namespace goniolux::planner
