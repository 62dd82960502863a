#include "spectrum/product_integral.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <limits>

namespace goniolux::spectrum {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Walks along one distribution from left to right; between two breakpoints its continuum is one straight line.
class Walk {
 public:
  Walk(const SpectralDistribution& distribution, double from)
      : distribution_(distribution), samples_(distribution.samples()) {
    const auto next = std::upper_bound(samples_.begin(), samples_.end(), from,
                                       [](double w, const auto& sample) { return w < sample.wavelength; });
    next_ = static_cast<std::size_t>(next - samples_.begin());
  }
  /// The first sample to the right of where the walk stands.
  [[nodiscard]] double nextBreak() const { return next_ < samples_.size() ? samples_[next_].wavelength : infinity; }
  void passTo(double wavelength) {
    while (next_ < samples_.size() && samples_[next_].wavelength <= wavelength) ++next_;
  }
  /// Value at `wavelength` of the straight line of the present stretch: at a jump, the limit from inside the stretch.
  [[nodiscard]] double value(double wavelength) const {
    if (next_ == 0 ||
        next_ == samples_.size()) {  // beyond the samples: constant there, whatever its right or left limit
      const double outside = next_ == 0 ? -infinity : infinity;
      return distribution_.continuum(samples_.empty() ? wavelength : outside);
    }
    const auto &a = samples_[next_ - 1], &b = samples_[next_];
    return a.value + (b.value - a.value) * (wavelength - a.wavelength) / (b.wavelength - a.wavelength);
  }

 private:
  const SpectralDistribution& distribution_;
  std::span<const SpectralDistribution::Sample> samples_;
  std::size_t next_ = 0;
};

}  // namespace

double integralOfProduct(std::initializer_list<const SpectralDistribution*> factors, double from, double to) {
  assert(factors.size() >= 1 && factors.size() <= 3);
  std::vector<Walk> walks;
  walks.reserve(factors.size());
  for (const SpectralDistribution* factor : factors) walks.emplace_back(*factor, from);
  const auto product = [&](double wavelength) {
    double value = 1;
    for (const Walk& walk : walks) value *= walk.value(wavelength);
    return value;
  };

  double sum = 0;
  for (double a = from; a < to;) {
    double b = to;
    for (const Walk& walk : walks) b = std::min(b, walk.nextBreak());
    // Simpson's rule is exact for the cubic that three straight lines make.
    sum += (b - a) / 6 * (product(a) + 4 * product((a + b) / 2) + product(b));
    for (Walk& walk : walks) walk.passTo(b);
    a = b;
  }
  const SpectralDistribution& source = **factors.begin();
  for (const auto& line : source.lines()) {
    if (line.wavelength < from || line.wavelength > to) continue;
    double through = line.power;
    for (auto other = factors.begin() + 1; other != factors.end(); ++other) {
      through *= (*other)->continuum(line.wavelength);
    }
    sum += through;
  }
  return sum;
}

}  // namespace goniolux::spectrum
