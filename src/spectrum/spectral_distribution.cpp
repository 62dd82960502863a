#include "spectrum/spectral_distribution.h"

#include <algorithm>
#include <cassert>

#include "spectrum/product_integral.h"

namespace goniolux::spectrum {

SpectralDistribution SpectralDistribution::flat(double value) {
  SpectralDistribution result;
  result.constant_ = value;
  return result;
}

SpectralDistribution SpectralDistribution::sampled(std::vector<Sample> samples, Outside outside) {
  assert(std::adjacent_find(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
           return !(a.wavelength < b.wavelength);
         }) == samples.end());
  SpectralDistribution result;
  result.samples_ = std::move(samples);
  result.outside_ = outside;
  return result;
}

void SpectralDistribution::addLine(Line line) {
  lines_.push_back(line);
}

double SpectralDistribution::continuum(double wavelength) const {
  if (samples_.empty()) return constant_;
  const Sample &first = samples_.front(), &last = samples_.back();
  if (wavelength < first.wavelength) return outside_ == Outside::hold ? first.value : 0.0;
  if (wavelength > last.wavelength) return outside_ == Outside::hold ? last.value : 0.0;
  const auto above = std::lower_bound(samples_.begin(), samples_.end(), wavelength,
                                      [](const Sample& sample, double w) { return sample.wavelength < w; });
  if (above->wavelength == wavelength) return above->value;
  const Sample &a = *(above - 1), &b = *above;
  return a.value + (b.value - a.value) * (wavelength - a.wavelength) / (b.wavelength - a.wavelength);
}

bool SpectralDistribution::isFlat() const {
  if (!lines_.empty()) return false;
  if (samples_.empty()) return true;
  const auto [lowest, highest] = range();
  return outside_ == Outside::hold && lowest == highest;
}

double SpectralDistribution::integral(const SpectralDistribution& weight, double from, double to) const {
  return integralOfProduct({this, &weight}, from, to);
}

double SpectralDistribution::integral(double from, double to) const {
  return integralOfProduct({this}, from, to);
}

std::pair<double, double> SpectralDistribution::range() const {
  if (samples_.empty()) return {constant_, constant_};
  const auto [lowest, highest] = std::minmax_element(
      samples_.begin(), samples_.end(), [](const Sample& a, const Sample& b) { return a.value < b.value; });
  return {lowest->value, highest->value};
}

SpectralDistribution SpectralDistribution::scaled(double factor) const {
  SpectralDistribution result = *this;
  result.constant_ *= factor;
  for (Sample& sample : result.samples_) sample.value *= factor;
  for (Line& line : result.lines_) line.power *= factor;
  return result;
}

}  // namespace goniolux::spectrum
