#include "reflection/roughness.h"

#include <algorithm>
#include <cmath>

#include "reflection/models.h"

namespace goniolux::reflection {

std::vector<core::Parameter> roughnessParameters(const std::string& help) {
  return {plainNumber("roughness", "roughness", 0, 1, "GGX alpha; " + help),
          plainNumber("rms_slope", "rms slope", 0, 0.7, "of the facets, instead of roughness: alpha = sqrt(2) m"),
          plainNumber("gloss", "gloss exponent", 0, 1e7,
                      "n of a lobe (N.H)^n, instead of roughness: alpha = sqrt(2/(n + 2))")};
}

double roughnessOf(const material::Material& material) {
  const auto number = [&](const char* key) {
    const auto found = material.numbers.find(key);
    return found == material.numbers.end() ? -1.0 : found->second;
  };
  if (const double alpha = number("roughness"); alpha >= 0) return std::min(1.0, alpha);
  if (const double slope = number("rms_slope"); slope >= 0) return std::min(1.0, std::sqrt(2.0) * slope);
  if (const double n = number("gloss"); n >= 0) return std::min(1.0, std::sqrt(2 / (n + 2)));
  return 0;
}

std::string roughnessComplaint(const material::Material& material) {
  const auto count =
      material.numbers.count("roughness") + material.numbers.count("rms_slope") + material.numbers.count("gloss");
  return count > 1 ? "\"roughness\", \"rms_slope\" and \"gloss\" say the same in different ways; leave only one of them"
                   : "";
}

}  // namespace goniolux::reflection
