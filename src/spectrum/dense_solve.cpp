#include "spectrum/dense_solve.h"

#include <cmath>
#include <utility>

namespace goniolux::spectrum {

bool solveDense(std::vector<double>& system, std::size_t n) {
  const std::size_t width = n + 1;
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < n; ++r) {
      if (std::abs(system[r * width + i]) > std::abs(system[pivot * width + i])) pivot = r;
    }
    if (!(std::abs(system[pivot * width + i]) > 1e-14)) return false;
    for (std::size_t c = i; c < width; ++c) std::swap(system[i * width + c], system[pivot * width + c]);
    for (std::size_t r = i + 1; r < n; ++r) {
      const double factor = system[r * width + i] / system[i * width + i];
      if (factor == 0) continue;
      for (std::size_t c = i; c < width; ++c) system[r * width + c] -= factor * system[i * width + c];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    double& x = system[i * width + n];
    for (std::size_t c = i + 1; c < n; ++c) x -= system[i * width + c] * system[c * width + n];
    x /= system[i * width + i];
  }
  return true;
}

}  // namespace goniolux::spectrum
