#include "spectrum/tristimulus_schemes.h"

#include <array>
#include <cstddef>

#include "spectrum/dense_solve.h"

namespace goniolux::spectrum {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr Matrix identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix srgbFromXyz{{{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}}};

// A channel's components from X, Y, Z: sensor k sees the sum over c of matrix[k][c] times the channel's weight.
SpectralQuadrature products(const SchemeInput& input, const char* name, const Matrix& matrix,
                            std::array<double, 3> wavelengths) {
  const auto& control = input.control;
  SpectralQuadrature result;
  result.scheme = name;
  result.values = NodeValues::weighed;
  result.wavelengths = {wavelengths.begin(), wavelengths.end()};
  for (std::size_t k = 0; k < 3; ++k) {
    Sensor sensor{control.wavelengths, {}};
    double sum = 0;
    for (std::size_t i = 0; i < control.wavelengths.size(); ++i) {
      double& weight = sensor.weights.emplace_back(0);
      for (const auto& weights : control.weights)
        for (std::size_t c = 0; c < 3; ++c) weight += matrix[k][c] * weights[i][c];
      sum += weight;
    }
    for (double& weight : sensor.weights) weight /= sum;
    result.sensors.push_back(std::move(sensor));
  }
  for (const auto& source : control.weights) {
    Response white{};
    for (const Response& weight : source)
      for (std::size_t c = 0; c < responseChannels; ++c) white[c] += weight[c];
    // Back from the white's components, each times what the path leaves of it: the columns of the inverse.
    auto& weights = result.weights.emplace_back(3, Response{});
    for (std::size_t k = 0; k < 3; ++k) {
      double component = 0;
      for (std::size_t c = 0; c < 3; ++c) component += matrix[k][c] * white[c];
      std::vector<double> system;
      for (std::size_t row = 0; row < 3; ++row) {
        system.insert(system.end(), matrix[row].begin(), matrix[row].end());
        system.push_back(row == k ? component : 0);
      }
      solveDense(system, 3);
      for (std::size_t c = 0; c < 3; ++c) weights[k][c] = system[c * 4 + 3];
      weights[k][3] = k == 2 ? white[3] : 0;  // the melanopic response goes with the short waves
    }
  }
  return result;
}

}  // namespace

SpectralQuadrature xyzScheme(const SchemeInput& input) {
  return products(input, "xyz:3", identity, {600, 555, 450});
}

SpectralQuadrature rgbScheme(const SchemeInput& input) {
  return products(input, "rgb:3", srgbFromXyz, {610, 550, 465});
}

}  // namespace goniolux::spectrum
