// Estimate: a computed quantity and the half-width of its confidence interval, statistical and systematic parts apart.
#pragma once

#include <map>
#include <string>

namespace goniolux::core {

/// value ± halfWidth() at the run's stated confidence. Unit: that of the quantity.
struct Estimate {
  double value = 0;
  double statistical = 0;  ///< half-width from independent replicates
  std::map<std::string, double>
      systematic;  ///< bounds by cause: "truncation", "spectral", "source_subdivision", "tessellation"

  [[nodiscard]] double halfWidth() const {
    double sum = statistical;
    for (const auto& [cause, bound] : systematic) sum += bound;
    return sum;
  }
};

}  // namespace goniolux::core
