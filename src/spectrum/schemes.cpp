#include "spectrum/schemes.h"

#include <algorithm>

#include "spectrum/fixed_schemes.h"
#include "spectrum/tristimulus_schemes.h"

namespace goniolux::spectrum {
namespace {

SpectralQuadrature adapted(const SchemeInput& input) {
  return adaptedQuadrature(input.count, input.control, input.paths);
}

SpectralQuadrature uniform(const SchemeInput& input) {
  return uniformQuadrature(input.count, input.sources);
}

SpectralQuadrature control(const SchemeInput& input) {
  return input.control;
}

}  // namespace

const std::vector<SpectralScheme>& spectralSchemes() {
  static const std::vector<SpectralScheme> schemes = {
      {"adapted", "nodes and weights for the scene's own light paths", 9, 1, 64, false, adapted},
      {"uniform", "equal steps over 400-700 nm, linear between", 9, 1, 471, false, uniform},
      {"point", "equal steps over 380-780 nm, everything sampled there, white made exact", 9, 1, 471, false,
       pointScheme},
      {"paper", "equal steps over 380-780 nm, everything sampled there: Hall & Greenberg's nine, as read", 9, 1, 471,
       true, paperScheme},
      {"bins", "equal bins over 400-700 nm, reflectances sampled at their middles", 9, 1, 471, false, binScheme},
      {"gauss", "Gauss quadrature weighted by the observer", 9, 2, 16, false, gaussScheme},
      {"meyer", "Meyer's four wavelengths", 4, 4, 4, false, meyerScheme},
      {"hero", "wavelengths spread by how visible they are, at a random offset", 4, 1, 471, false, heroScheme},
      {"xyz", "products of tristimulus values X, Y, Z", 3, 3, 3, true, xyzScheme},
      {"rgb", "products of linear sRGB values", 3, 3, 3, true, rgbScheme},
      {"control", "every nanometre, and the lines of the sources", 471, 471, 471, false, control},
  };
  return schemes;
}

const SpectralScheme* findSpectralScheme(const std::string& name) {
  const auto& all = spectralSchemes();
  const auto found = std::find_if(all.begin(), all.end(), [&](const SpectralScheme& s) { return s.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace goniolux::spectrum
