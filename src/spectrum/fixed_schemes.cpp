#include "spectrum/fixed_schemes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "spectrum/cie_data.h"
#include "spectrum/hats.h"

namespace goniolux::spectrum {
namespace {

std::string named(const char* name, std::size_t count) {
  return std::string(name) + ":" + std::to_string(count);
}

std::vector<double> middles(double from, double to, int count) {
  std::vector<double> nodes;
  for (int k = 0; k < count; ++k) nodes.push_back(from + (to - from) * (k + 0.5) / count);
  return nodes;
}

/// Weights by sharing the control's among the nodes: share(wavelength) gives one share per node; they sum to 1.
template <typename Share>
std::vector<std::vector<Response>> sharedWeights(const SchemeInput& input, std::size_t nodes, Share share) {
  const auto& control = input.control;
  std::vector<std::vector<Response>> weights(control.weights.size(), std::vector<Response>(nodes, Response{}));
  for (std::size_t i = 0; i < control.wavelengths.size(); ++i) {
    const std::vector<double> shares = share(control.wavelengths[i]);
    for (std::size_t s = 0; s < weights.size(); ++s)
      for (std::size_t k = 0; k < nodes; ++k)
        for (std::size_t c = 0; c < responseChannels; ++c) weights[s][k][c] += shares[k] * control.weights[s][i][c];
  }
  return weights;
}

std::vector<std::vector<Response>> hatWeights(const SchemeInput& input, const std::vector<double>& nodes) {
  const auto shapes = hats(nodes);
  return sharedWeights(input, nodes.size(), [&](double wavelength) {
    std::vector<double> shares;
    for (const Hat& hat : shapes) shares.push_back(hat.shape.continuum(wavelength));
    return shares;
  });
}

// Scales each channel of each source to the control's white; a channel that the nodes do not see at all is taken from
// hats, so that a lamp of lines is not dark.
void makeWhiteExact(const SchemeInput& input, SpectralQuadrature& quadrature) {
  const auto hat = hatWeights(input, quadrature.wavelengths);
  for (std::size_t s = 0; s < quadrature.weights.size(); ++s) {
    for (std::size_t c = 0; c < responseChannels; ++c) {
      double white = 0, sum = 0;
      for (const Response& w : input.control.weights[s]) white += w[c];
      for (const Response& w : quadrature.weights[s]) sum += w[c];
      for (std::size_t k = 0; k < quadrature.wavelengths.size(); ++k) {
        double& weight = quadrature.weights[s][k][c];
        weight = sum > 1e-9 * white ? weight * white / sum : hat[s][k][c];
      }
    }
  }
}

const std::array<const SpectralDistribution*, responseChannels>& channels() {
  static const std::array<const SpectralDistribution*, responseChannels> all{&cie1931().xbar, &cie1931().ybar,
                                                                             &cie1931().zbar, &melanopicAction()};
  return all;
}

SpectralQuadrature points(const SchemeInput& input, const char* name) {
  constexpr double from = 380, to = 780;
  SpectralQuadrature result;
  result.scheme = named(name, static_cast<std::size_t>(input.count));
  result.values = NodeValues::sampled;
  result.wavelengths = middles(from, to, input.count);
  for (const SpectralDistribution& source : input.sources) {
    const double luminous = source.integral(cie1931().ybar, visibleFrom, visibleTo);
    auto& weights = result.weights.emplace_back();
    for (const double wavelength : result.wavelengths) {
      const double power = source.continuum(wavelength) * (to - from) / input.count / luminous;
      Response& weight = weights.emplace_back();
      for (std::size_t c = 0; c < responseChannels; ++c) weight[c] = power * channels()[c]->continuum(wavelength);
    }
  }
  return result;
}

// Eigenvalues of a symmetric tridiagonal matrix by bisection on the sign changes of its Sturm sequence, ascending.
std::vector<double> eigenvalues(const std::vector<double>& diagonal, const std::vector<double>& beside, double from,
                                double to) {
  const auto below = [&](double x) {  // how many eigenvalues are less than x
    int count = 0;
    double d = 1;
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      d = diagonal[i] - x - (i == 0 ? 0 : beside[i - 1] * beside[i - 1] / d);
      if (d == 0) d = 1e-300;
      if (d < 0) ++count;
    }
    return count;
  };
  std::vector<double> values;
  for (std::size_t k = 0; k < diagonal.size(); ++k) {
    double low = from, high = to;
    for (int step = 0; step < 80; ++step) {
      const double middle = (low + high) / 2;
      (below(middle) > static_cast<int>(k) ? high : low) = middle;
    }
    values.push_back((low + high) / 2);
  }
  return values;
}

// Nodes of the Gauss quadrature for the weight xbar + ybar + zbar: Stieltjes' recurrence for its orthogonal
// polynomials, whose Jacobi matrix has the nodes as eigenvalues — Golub & Welsch, Math. Comp. 23, 1969.
std::vector<double> gaussNodes(int count) {
  const double centre = (visibleFrom + visibleTo) / 2, half = (visibleTo - visibleFrom) / 2;
  std::vector<double> x, weight;
  for (double nm = visibleFrom; nm <= visibleTo; nm += 1) {
    x.push_back((nm - centre) / half);
    weight.push_back(cie1931().xbar.continuum(nm) + cie1931().ybar.continuum(nm) + cie1931().zbar.continuum(nm));
  }
  std::vector<double> diagonal, beside, before(x.size(), 0.0), p(x.size(), 1.0);
  double normBefore = 1;
  for (int j = 0; j < count; ++j) {
    double norm = 0, first = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      norm += weight[i] * p[i] * p[i];
      first += weight[i] * p[i] * p[i] * x[i];
    }
    const double a = first / norm, b = j > 0 ? norm / normBefore : 0;
    diagonal.push_back(a);
    if (j > 0) beside.push_back(std::sqrt(b));
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double next = (x[i] - a) * p[i] - b * before[i];
      before[i] = p[i];
      p[i] = next;
    }
    normBefore = norm;
  }
  std::vector<double> nodes = eigenvalues(diagonal, beside, -1, 1);
  for (double& node : nodes) node = centre + half * node;
  return nodes;
}

}  // namespace

SpectralQuadrature paperScheme(const SchemeInput& input) {
  return points(input, "paper");
}

SpectralQuadrature pointScheme(const SchemeInput& input) {
  SpectralQuadrature result = points(input, "point");
  makeWhiteExact(input, result);
  return result;
}

SpectralQuadrature binScheme(const SchemeInput& input) {
  constexpr double from = 400, to = 700;
  SpectralQuadrature result;
  result.scheme = named("bins", static_cast<std::size_t>(input.count));
  result.values = NodeValues::sampled;
  result.wavelengths = middles(from, to, input.count);
  const auto count = static_cast<std::size_t>(input.count);
  result.weights = sharedWeights(input, count, [&](double wavelength) {
    const double place = std::clamp((wavelength - from) / (to - from) * input.count, 0.0, input.count - 0.5);
    std::vector<double> shares(count, 0.0);
    shares[static_cast<std::size_t>(place)] = 1;
    return shares;
  });
  return result;
}

SpectralQuadrature gaussScheme(const SchemeInput& input) {
  SpectralQuadrature result;
  result.scheme = named("gauss", static_cast<std::size_t>(input.count));
  result.values = NodeValues::sampled;
  result.wavelengths = gaussNodes(input.count);
  const auto& nodes = result.wavelengths;
  result.weights = sharedWeights(input, nodes.size(), [&](double wavelength) {
    std::vector<double> shares;  // Lagrange's polynomials
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      double product = 1;
      for (std::size_t m = 0; m < nodes.size(); ++m)
        if (m != k) product *= (wavelength - nodes[m]) / (nodes[k] - nodes[m]);
      shares.push_back(product);
    }
    return shares;
  });
  return result;
}

SpectralQuadrature meyerScheme(const SchemeInput& input) {
  constexpr double matrix[3][4] = {
      {0.1986, -0.0569, 0.4934, 0.4228}, {-0.0034, 0.1856, 0.6770, 0.1998}, {0.9632, 0.0931, 0.0806, -0.0791}};
  SpectralQuadrature result;
  result.scheme = "meyer:4";
  result.values = NodeValues::sampled;
  result.wavelengths = {456.4, 490.9, 557.7, 631.4};
  result.weights = hatWeights(input, result.wavelengths);  // the melanopic channel, which Meyer does not have, stays
  for (std::size_t s = 0; s < input.sources.size(); ++s) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double power = input.sources[s].continuum(result.wavelengths[k]);
      for (std::size_t c = 0; c < 3; ++c) result.weights[s][k][c] = matrix[c][k] * power;
    }
  }
  makeWhiteExact(input, result);
  return result;
}

SpectralQuadrature heroScheme(const SchemeInput& input) {
  const auto& control = input.control;
  std::vector<double> density(control.wavelengths.size(), 0.0);
  double total = 0;
  for (std::size_t i = 0; i < density.size(); ++i) {
    for (const auto& weights : control.weights) density[i] += weights[i][0] + weights[i][1] + weights[i][2];
    total += density[i];
  }
  SpectralQuadrature result;
  result.scheme = named("hero", static_cast<std::size_t>(input.count));
  result.values = NodeValues::sampled;
  result.weights.resize(control.weights.size());
  std::size_t i = 0;
  double sum = density.empty() ? 0 : density[0];
  for (int k = 0; k < input.count; ++k) {
    const double quantile = (k + input.offset) / input.count * total;
    while (sum < quantile && i + 1 < density.size()) sum += density[++i];
    result.wavelengths.push_back(control.wavelengths[i]);
    // One of `count` samples, chosen with probability density / total.
    const double inverse = total / (density[i] * input.count);
    for (std::size_t s = 0; s < result.weights.size(); ++s) {
      Response& weight = result.weights[s].emplace_back();
      for (std::size_t c = 0; c < responseChannels; ++c) weight[c] = inverse * control.weights[s][i][c];
    }
  }
  return result;
}

}  // namespace goniolux::spectrum
