#include "planner/spectral_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "spectrum/adapted_quadrature.h"
#include "spectrum/colorimetry.h"
#include "spectrum/colour_difference.h"

namespace goniolux::planner {
namespace {

using spectrum::Response;

// The paths looked at are a choice: others may be somewhat worse; and no fewer wavelengths than the control's are
// called better than these.
constexpr double unseenMargin = 1.5, leastRelative = 1e-4, leastColour = 0.01;

std::vector<std::vector<double>> reflectancesAt(const std::vector<Finish>& finishes,
                                                const spectrum::SpectralQuadrature& quadrature) {
  std::vector<std::vector<double>> values;
  for (const Finish& finish : finishes) values.push_back(spectrum::atNodes(finish.reflectance, quadrature));
  return values;
}

spectrum::Xyz xyz(const Response& response) {
  return {response[0], response[1], response[2]};
}

}  // namespace

SpectralErrors::SpectralErrors(const std::vector<Finish>& finishes,
                               const std::vector<spectrum::SpectralDistribution>& sources)
    : finishes_(finishes),
      paths_(finishes),
      control_(spectrum::controlQuadrature(sources)),
      fine_(paths_.transmittances(reflectancesAt(finishes, control_))) {
  for (const auto& weights : control_.weights) {
    auto& responses = exact_.emplace_back();
    for (const auto& path : fine_) responses.push_back(spectrum::responseOf(weights, path));
  }
}

SpectralError SpectralErrors::of(const spectrum::SpectralQuadrature& quadrature) const {
  const auto coarse = paths_.transmittances(reflectancesAt(finishes_, quadrature));
  const std::vector<double> unreflected(quadrature.wavelengths.size(), 1.0);
  SpectralError worst;
  for (std::size_t s = 0; s < exact_.size(); ++s) {
    const auto& weights = quadrature.weights[s];
    const Response light = spectrum::responseOf(weights, unreflected);
    for (std::size_t j = 0; j < coarse.size(); ++j) {
      const Response &exact = exact_[s][j], found = spectrum::responseOf(weights, coarse[j]);
      const double error = std::abs(found[1] - exact[1]) / std::max(exact[1], spectrum::darkestShare * light[1]);
      if (paths_.seen(j) == LightPaths::Seen::byGrid) {
        worst.illuminance = std::max(worst.illuminance, error);
        worst.melanopic = std::max(
            worst.melanopic, std::abs(found[3] - exact[3]) / std::max(exact[3], spectrum::darkestShare * light[3]));
        continue;
      }
      worst.luminance = std::max(worst.luminance, error);
      worst.colour = std::max(worst.colour, spectrum::deltaE2000(spectrum::lab(xyz(found), xyz(light)),
                                                                 spectrum::lab(xyz(exact), xyz(light))));
    }
  }
  worst.illuminance = std::max(unseenMargin * worst.illuminance, leastRelative);
  worst.melanopic = std::max(unseenMargin * worst.melanopic, leastRelative);
  worst.luminance = std::max(unseenMargin * worst.luminance, leastRelative);
  worst.colour = std::max(unseenMargin * worst.colour, leastColour);
  return worst;
}

}  // namespace goniolux::planner
