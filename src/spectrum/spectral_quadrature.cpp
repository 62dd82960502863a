#include "spectrum/spectral_quadrature.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>

#include "spectrum/cie_data.h"
#include "spectrum/hats.h"
#include "spectrum/product_integral.h"

namespace goniolux::spectrum {
namespace {

SpectralQuadrature quadrature(std::string scheme, std::vector<double> nodes,
                              const std::vector<SpectralDistribution>& sources) {
  SpectralQuadrature result;
  result.scheme = std::move(scheme);
  result.wavelengths = std::move(nodes);
  const auto shapes = hats(result.wavelengths);
  const std::array<const SpectralDistribution*, responseChannels> channels{&cie1931().xbar, &cie1931().ybar,
                                                                           &cie1931().zbar, &melanopicAction()};
  for (const SpectralDistribution& source : sources) {
    const double luminous = source.integral(cie1931().ybar, visibleFrom, visibleTo);
    if (!(luminous > 0)) throw std::invalid_argument("a source spectrum has no luminous power");
    auto& weights = result.weights.emplace_back(result.wavelengths.size());
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      for (std::size_t c = 0; c < channels.size(); ++c) {
        // A line on a node belongs to that node's hat whole: its neighbours' hats are 0 there.
        weights[k][c] =
            integralOfProduct({&source, channels[c], &shapes[k].shape}, shapes[k].from, shapes[k].to) / luminous;
      }
    }
  }
  return result;
}

// Sum of the colour-matching functions; all three tables have the same wavelengths.
SpectralDistribution everythingSeen() {
  std::vector<SpectralDistribution::Sample> samples;
  for (const auto& [wavelength, y] : cie1931().ybar.samples()) {
    samples.push_back({wavelength, cie1931().xbar.continuum(wavelength) + y + cie1931().zbar.continuum(wavelength)});
  }
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::zero);
}

// Solves M v = b in place (v holds b) for a symmetric, positive definite, tridiagonal M: Thomas' algorithm.
void solve(std::vector<double>& diagonal, const std::vector<double>& beside, std::vector<double>& v) {
  for (std::size_t k = 1; k < v.size(); ++k) {
    const double factor = beside[k - 1] / diagonal[k - 1];
    diagonal[k] -= factor * beside[k - 1];
    v[k] -= factor * v[k - 1];
  }
  for (std::size_t k = v.size(); k-- > 0;) {
    if (k + 1 < v.size()) v[k] -= beside[k] * v[k + 1];
    v[k] /= diagonal[k];
  }
}

}  // namespace

Response responseOf(const std::vector<Response>& weights, const std::vector<double>& transmittance) {
  Response sum{};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += weights[k][c] * transmittance[k];
  }
  return sum;
}

SpectralQuadrature flatQuadrature(const std::vector<SpectralDistribution>& sources) {
  return quadrature("flat:1", {550}, sources);
}

SpectralQuadrature uniformQuadrature(int count, const std::vector<SpectralDistribution>& sources) {
  assert(count >= 1);
  const bool wide = count >= 81;  // enough nodes to spend some on the faint ends of the visible range
  const double from = wide ? visibleFrom : 400, to = wide ? visibleTo : 700;
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(count == 1 ? 550 : from + (to - from) * i / (count - 1));
  return quadrature("uniform:" + std::to_string(count), std::move(nodes), sources);
}

SpectralQuadrature controlQuadrature(const std::vector<SpectralDistribution>& sources) {
  std::set<double> lines;
  for (const SpectralDistribution& source : sources) {
    for (const auto& line : source.lines()) {
      if (line.wavelength >= visibleFrom && line.wavelength <= visibleTo) lines.insert(line.wavelength);
    }
  }
  std::set<double> nodes;
  for (double nanometre = visibleFrom; nanometre <= visibleTo; nanometre += 1) nodes.insert(nanometre);
  for (const double line : lines) nodes.erase(std::round(line));
  nodes.insert(lines.begin(), lines.end());
  SpectralQuadrature result =
      quadrature("control:" + std::to_string(nodes.size()), {nodes.begin(), nodes.end()}, sources);
  result.values = NodeValues::sampled;
  return result;
}

std::vector<double> atNodes(const SpectralDistribution& distribution, const SpectralQuadrature& quadrature) {
  const auto& nodes = quadrature.wavelengths;
  const std::size_t count = nodes.size();
  if (quadrature.values == NodeValues::sampled) {
    std::vector<double> samples;
    for (const double wavelength : nodes) samples.push_back(distribution.continuum(wavelength));
    return samples;
  }
  if (quadrature.values == NodeValues::weighed) {
    std::vector<double> means(count, 0.0);
    for (std::size_t k = 0; k < count; ++k) {
      const Sensor& sensor = quadrature.sensors[k];
      for (std::size_t i = 0; i < sensor.weights.size(); ++i)
        means[k] += sensor.weights[i] * distribution.continuum(sensor.wavelengths[i]);
    }
    return means;
  }
  const auto range = distribution.range();
  if (distribution.isFlat()) return std::vector<double>(count, range.first);

  static const SpectralDistribution all = everythingSeen();
  const SpectralDistribution& weight = count == 1 ? cie1931().ybar : all;
  // Normal equations of the weighted least-squares fit: M v = b, M[j][k] = integral of hat_j hat_k weight
  // (tridiagonal).
  const auto shapes = hats(nodes);
  std::vector<double> diagonal(count), beside(count), v(count), mean(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [shape, from, to] = shapes[k];
    diagonal[k] = integralOfProduct({&weight, &shape, &shape}, from, to);
    if (k + 1 < count) beside[k] = integralOfProduct({&weight, &shape, &shapes[k + 1].shape}, nodes[k], nodes[k + 1]);
    v[k] = integralOfProduct({&weight, &shape, &distribution}, from, to);
    mean[k] = v[k] / integralOfProduct({&weight, &shape}, from, to);
  }
  solve(diagonal, beside, v);
  // Both the fit and the means keep the integral of the distribution times the weight, so any mixture of them does.
  const double lowest = std::min(0.0, range.first), highest = std::max(1.0, range.second);
  constexpr double rounding = 1e-9;
  double fitted = 1;
  for (std::size_t k = 0; k < count; ++k) {
    // Beyond rounding only: where the mean itself is at the limit the quotient would be 0 / 0.
    if (v[k] < lowest - rounding) fitted = std::min(fitted, std::max(0.0, (mean[k] - lowest) / (mean[k] - v[k])));
    if (v[k] > highest + rounding) fitted = std::min(fitted, std::max(0.0, (highest - mean[k]) / (v[k] - mean[k])));
  }
  for (std::size_t k = 0; k < count; ++k) v[k] = std::clamp(mean[k] + fitted * (v[k] - mean[k]), lowest, highest);
  return v;
}

}  // namespace goniolux::spectrum
