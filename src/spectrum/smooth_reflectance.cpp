#include "spectrum/smooth_reflectance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "spectrum/cie_data.h"
#include "spectrum/dense_solve.h"
#include "spectrum/hats.h"
#include "spectrum/product_integral.h"

namespace goniolux::spectrum {
namespace {

using Xyz = std::array<double, 3>;

constexpr std::size_t nodeCount = 48,
                      unknowns = nodeCount + 3;  // nodes, and one Lagrange multiplier per tristimulus value

std::vector<double> nodeWavelengths() {
  std::vector<double> nodes;
  for (std::size_t k = 0; k < nodeCount; ++k) nodes.push_back(visibleFrom + 10 * static_cast<double>(k));
  return nodes;
}

// Weight of each node's reflectance in X, Y, Z under D65; the weights of Y sum to 1.
const std::vector<Xyz>& weights() {
  static const std::vector<Xyz> result = [] {
    const auto d65 = illuminant("CIE D65").value();
    const Observer& observer = cie1931();
    const double luminous = d65.integral(observer.ybar, visibleFrom, visibleTo);
    std::vector<Xyz> table;
    for (const auto& [shape, from, to] : hats(nodeWavelengths())) {
      table.push_back({integralOfProduct({&d65, &observer.xbar, &shape}, from, to) / luminous,
                       integralOfProduct({&d65, &observer.ybar, &shape}, from, to) / luminous,
                       integralOfProduct({&d65, &observer.zbar, &shape}, from, to) / luminous});
    }
    return table;
  }();
  return result;
}

const Xyz& white() {
  static const Xyz result = [] {
    Xyz sum{};
    for (const Xyz& weight : weights()) {
      for (std::size_t c = 0; c < 3; ++c) sum[c] += weight[c];
    }
    return sum;
  }();
  return result;
}

// z at the nodes, then the three multipliers.
using State = std::vector<double>;

// Newton's iteration for the stationary point of sum (z[k+1] - z[k])^2 + multipliers . (colour - target) — Burns 2020,
// appendix.
bool converge(State& state, const Xyz& target) {
  const auto& W = weights();
  for (int iteration = 0; iteration < 30; ++iteration) {
    std::vector<double> system(unknowns * (unknowns + 1));
    const auto at = [&](std::size_t row, std::size_t column) -> double& {
      return system[row * (unknowns + 1) + column];
    };
    Xyz miss{};
    double largest = 0;
    for (std::size_t k = 0; k < nodeCount; ++k) {
      const double t = std::tanh(state[k]), slope = (1 - t * t) / 2, bend = -2 * t * slope;  // of (1 + tanh z) / 2
      double pull = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        pull += W[k][c] * state[nodeCount + c];
        miss[c] += W[k][c] * (1 + t) / 2;
        at(k, nodeCount + c) = at(nodeCount + c, k) = slope * W[k][c];
      }
      double gradient = slope * pull;
      at(k, k) = bend * pull;
      for (const std::size_t beside : {k - 1, k + 1}) {  // k - 1 wraps far above nodeCount at 0
        if (beside >= nodeCount) continue;
        at(k, k) += 2;
        at(k, beside) = -2;
        gradient += 2 * (state[k] - state[beside]);
      }
      at(k, unknowns) = -gradient;
      largest = std::max(largest, std::abs(gradient));
    }
    for (std::size_t c = 0; c < 3; ++c) {
      miss[c] -= target[c];
      at(nodeCount + c, unknowns) = -miss[c];
      largest = std::max(largest, std::abs(miss[c]));
    }
    if (largest < 1e-12) return true;
    if (!solveDense(system, unknowns)) return false;
    double step = 0;
    for (std::size_t i = 0; i < unknowns; ++i) {
      state[i] += at(i, unknowns);
      if (i < nodeCount) step = std::max(step, std::abs(at(i, unknowns)));
    }
    if (!(step < 50)) return false;  // running away, or NaN
  }
  return false;
}

double decoded(double value) {  // sRGB transfer function — IEC 61966-2-1
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

std::optional<SpectralDistribution> reflectanceFromXyz(const Xyz& xyz) {
  const double Y = xyz[1];
  Xyz grey{};
  double colourfulness = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    grey[c] = Y * white()[c];
    if (!std::isfinite(xyz[c])) return std::nullopt;
    colourfulness = std::max(colourfulness, std::abs(xyz[c] - grey[c]));
  }
  if (Y < 0 || Y > 1 + 1e-9) return std::nullopt;
  if (colourfulness < 1e-7) return SpectralDistribution::flat(std::min(Y, 1.0));
  if (Y == 0 || Y >= 1) return std::nullopt;

  // The grey of the same luminance is known exactly; from there the colour is approached in steps that Newton's
  // iteration can follow.
  State state(unknowns, 0.0);
  std::fill_n(state.begin(), nodeCount, std::atanh(2 * Y - 1));
  double reached = 0, step = 1;
  while (reached < 1) {
    const double aim = std::min(1.0, reached + step);
    Xyz target{};
    for (std::size_t c = 0; c < 3; ++c) target[c] = grey[c] + aim * (xyz[c] - grey[c]);
    State attempt = state;
    if (converge(attempt, target)) {
      state = std::move(attempt);
      reached = aim;
      step *= 2;
    } else {
      step /= 2;
      if (step < 1e-4) return std::nullopt;  // the boundary of the colours that reflectances can have
    }
  }
  const auto nodes = nodeWavelengths();
  std::vector<SpectralDistribution::Sample> samples;
  for (std::size_t k = 0; k < nodeCount; ++k) samples.push_back({nodes[k], (1 + std::tanh(state[k])) / 2});
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::hold);
}

std::optional<SpectralDistribution> reflectanceFromSrgb(const std::array<double, 3>& rgb) {
  for (const double value : rgb) {
    if (!(value >= 0 && value <= 1)) return std::nullopt;
  }
  const double r = decoded(rgb[0]), g = decoded(rgb[1]), b = decoded(rgb[2]);
  // The standard's matrix, each row divided by its sum and scaled to D65 as it is tabulated: sRGB's white becomes
  // reflectance 1.
  return reflectanceFromXyz({(0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505 * white()[0],
                             (0.2126 * r + 0.7152 * g + 0.0722 * b) / 1.0000 * white()[1],
                             (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.0890 * white()[2]});
}

}  // namespace goniolux::spectrum
