// SpectralDistribution: a function of wavelength, as a piecewise linear continuum plus ideal lines. Serves for spectral
// power (relative), reflectance and transmittance alike. Wavelengths in nm. A value type: copies are independent,
// reading is thread safe.
#pragma once

#include <span>
#include <utility>
#include <vector>

namespace goniolux::spectrum {

class SpectralDistribution {
 public:
  struct Sample {
    double wavelength, value;
  };
  /// An ideal line: `power` is its integral over wavelength (value x nm), as a photometer sees it.
  struct Line {
    double wavelength, power;
  };
  /// What holds beyond the first and the last sample: sources stop, reflectances continue.
  enum class Outside { zero, hold };

  /// The constant 0.
  SpectralDistribution() = default;
  /// The same value at every wavelength.
  static SpectralDistribution flat(double value);
  /// Samples in strictly ascending wavelength (asserted; readers check), joined by straight lines.
  static SpectralDistribution sampled(std::vector<Sample> samples, Outside outside);

  void addLine(Line line);

  /// Continuum at a wavelength; lines are not part of it.
  [[nodiscard]] double continuum(double wavelength) const;
  /// True when the continuum is one constant everywhere and there are no lines: a grey reflectance needs one spectral
  /// sample.
  [[nodiscard]] bool isFlat() const;
  /// Views into this object; not of one that ends with the statement.
  [[nodiscard]] std::span<const Sample> samples() const& { return samples_; }
  std::span<const Sample> samples() const&& = delete;
  [[nodiscard]] std::span<const Line> lines() const& { return lines_; }
  std::span<const Line> lines() const&& = delete;

  /// Exact integral over [from, to] of this times `weight`'s continuum; this distribution's lines count, weight's do
  /// not.
  [[nodiscard]] double integral(const SpectralDistribution& weight, double from = 360, double to = 830) const;
  [[nodiscard]] double integral(double from = 360, double to = 830) const;
  /// Largest and smallest continuum value.
  [[nodiscard]] std::pair<double, double> range() const;

  /// This distribution with everything multiplied by `factor`.
  [[nodiscard]] SpectralDistribution scaled(double factor) const;

  friend bool operator==(const SpectralDistribution&, const SpectralDistribution&) = default;

 private:
  std::vector<Sample> samples_;  // empty: the constant constant_
  std::vector<Line> lines_;
  double constant_ = 0;
  Outside outside_ = Outside::zero;
};

inline bool operator==(const SpectralDistribution::Sample& a, const SpectralDistribution::Sample& b) {
  return a.wavelength == b.wavelength && a.value == b.value;
}
inline bool operator==(const SpectralDistribution::Line& a, const SpectralDistribution::Line& b) {
  return a.wavelength == b.wavelength && a.power == b.power;
}

}  // namespace goniolux::spectrum
