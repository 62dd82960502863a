#include "spectrum/hats.h"

#include <cstddef>

namespace goniolux::spectrum {

std::vector<Hat> hats(const std::vector<double>& nodes) {
  std::vector<Hat> result;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const bool first = k == 0, last = k + 1 == nodes.size();
    std::vector<SpectralDistribution::Sample> samples;
    if (!first) samples.push_back({nodes[k - 1], 0});
    samples.push_back({nodes[k], 1});
    if (!last) samples.push_back({nodes[k + 1], 0});
    result.push_back({SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::hold),
                      first ? visibleFrom : nodes[k - 1], last ? visibleTo : nodes[k + 1]});
  }
  return result;
}

}  // namespace goniolux::spectrum
