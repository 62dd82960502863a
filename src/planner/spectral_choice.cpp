#include "planner/spectral_choice.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "spectrum/adapted_quadrature.h"

namespace goniolux::planner {
namespace {

using spectrum::LightPath;

constexpr int mostAdapted = 16;
constexpr int coarserThanControl[] = {31, 81};
constexpr std::size_t widestSolved = 480;  // spectral samples that solvers are compiled for
// Paths that the fit looks at; of more, an even choice. The measured error is that of all.
constexpr std::size_t mostFitted = 250;
// Relative errors of X (and of Z, to which CIEDE2000 answers less) that look as bad as one unit of CIEDE2000.
constexpr double relativePerUnit = 0.01, relativeZPerUnit = 0.025;
// Where nobody looks at colours, X, Z and the melanopic response need no more than this.
constexpr double unseen = 0.05;

bool meets(const SpectralError& error, const SpectralAllowance& allowance) {
  return error.illuminance <= allowance.illuminance &&
         (!allowance.melanopic || error.melanopic <= allowance.illuminance) &&
         (!allowance.pictures || (error.luminance <= allowance.luminance && error.colour <= allowance.colour));
}

// What each path may spoil, so that the fit spends its freedom where the allowance is tight.
std::vector<LightPath> fittedPaths(const SpectralErrors& errors, const SpectralAllowance& allowance) {
  const LightPaths& paths = errors.paths();
  std::vector<LightPath> result;
  const std::size_t count = std::min(paths.size(), mostFitted);
  const double X = allowance.pictures ? relativePerUnit * allowance.colour : unseen;
  const double Z = allowance.pictures ? relativeZPerUnit * allowance.colour : unseen;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = i * paths.size() / count;
    const bool byGrid = paths.seen(j) == LightPaths::Seen::byGrid;
    if (!byGrid && !allowance.pictures) continue;
    const double Y = byGrid ? allowance.illuminance : std::min(allowance.luminance, relativePerUnit * allowance.colour);
    const double melanopic = byGrid && allowance.melanopic ? allowance.illuminance : unseen;
    result.push_back({errors.transmittances()[j], {X, Y, Z, melanopic}});
  }
  return result;
}

}  // namespace

SpectralChoice wavelengthsOf(const spectrum::SpectralScheme& scheme, int count, const std::vector<Finish>& finishes,
                             const std::vector<spectrum::SpectralDistribution>& sources,
                             const SpectralAllowance& allowance) {
  const SpectralErrors errors(finishes, sources);
  const std::vector<LightPath> paths = fittedPaths(errors, allowance);
  SpectralChoice choice;
  choice.quadrature = scheme.make({count, sources, errors.control(), paths});
  choice.error = errors.of(choice.quadrature);
  return choice;
}

SpectralChoice atWavelengths(const std::vector<double>& wavelengths, const std::vector<Finish>& finishes,
                             const std::vector<spectrum::SpectralDistribution>& sources,
                             const SpectralAllowance& allowance) {
  const SpectralErrors errors(finishes, sources);
  SpectralChoice choice;
  choice.quadrature = spectrum::adaptedWeights(wavelengths, errors.control(), fittedPaths(errors, allowance));
  choice.error = errors.of(choice.quadrature);
  return choice;
}

SpectralChoice chooseWavelengths(const std::vector<Finish>& finishes,
                                 const std::vector<spectrum::SpectralDistribution>& sources,
                                 const SpectralAllowance& allowance) {
  const bool grey =
      std::all_of(finishes.begin(), finishes.end(), [](const Finish& f) { return f.reflectance.isFlat(); });
  if ((grey && allowance.leastCount <= 1) || sources.empty()) return {spectrum::flatQuadrature(sources), {}};
  const SpectralErrors errors(finishes, sources);
  const std::vector<LightPath> fitted = fittedPaths(errors, allowance);
  SpectralChoice choice;
  for (int count = std::clamp(allowance.leastCount, 1, mostAdapted); count <= mostAdapted; ++count) {
    choice.quadrature = spectrum::adaptedQuadrature(count, errors.control(), fitted);
    choice.error = errors.of(choice.quadrature);
    if (meets(choice.error, allowance)) return choice;
  }
  for (const int count : coarserThanControl) {
    choice.quadrature = spectrum::uniformQuadrature(count, sources);
    choice.error = errors.of(choice.quadrature);
    if (meets(choice.error, allowance)) return choice;
  }
  if (errors.control().wavelengths.size() <= widestSolved) return {errors.control(), {}};
  choice.quadrature = spectrum::uniformQuadrature(471, sources);  // lamps of very many lines
  choice.error = errors.of(choice.quadrature);
  return choice;
}

}  // namespace goniolux::planner
