#include "spectrum/tm30.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "spectrum/cam02.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "spectrum/reference_illuminant.h"

namespace goniolux::spectrum {
namespace {

constexpr double toWhite = 100;
constexpr double scale = 6.73;  // ANSI/IES TM-30-20, 3.3: FL1 to FL12 keep the mean of their R_a

SpectralDistribution referenceFor(const SpectralDistribution& source) {
  constexpr double planckUpTo = 4000, daylightFrom = 5000;
  const double kelvin = std::min(colourTemperature(tristimulus(source)).kelvin, 25000.0);
  if (kelvin <= planckUpTo) return atWavelengthsOf(source, blackbody(kelvin));
  if (kelvin >= daylightFrom) return atWavelengthsOf(source, daylight(kelvin));
  // Both at the same luminance; the 1964 observer's, as all here.
  const auto planck = atWavelengthsOf(source, blackbody(kelvin)), sky = atWavelengthsOf(source, daylight(kelvin));
  const double share = (daylightFrom - kelvin) / (daylightFrom - planckUpTo);
  const double ofPlanck = share / tristimulus(planck, cie1964()).Y, ofSky = (1 - share) / tristimulus(sky, cie1964()).Y;
  std::vector<SpectralDistribution::Sample> samples;
  for (const auto& [wavelength, power] : planck.samples())
    samples.push_back({wavelength, ofPlanck * power + ofSky * sky.continuum(wavelength)});
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::zero);
}

std::vector<Cam02Ucs> appearances(const SpectralDistribution& source) {
  const auto scaled = [](const Xyz& colour, double factor) {
    return Xyz{factor * colour.X, factor * colour.Y, factor * colour.Z};
  };
  const Xyz light = tristimulus(source, cie1964());
  const Xyz white = scaled(light, toWhite / light.Y);
  std::vector<Cam02Ucs> result;
  for (const SpectralDistribution& sample : colourEvaluationSamples())
    result.push_back(cam02Ucs(scaled(tristimulus(sample, source, cie1964()), toWhite), white));
  return result;
}

double fidelity(double difference) {
  return 10 * std::log(std::exp((100 - scale * difference) / 10) + 1);
}

double area(const std::array<Cam02Ucs, 16>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Cam02Ucs &p = corners[i], &q = corners[(i + 1) % corners.size()];
    sum += p.a * q.b - q.a * p.b;
  }
  return sum / 2;
}

}  // namespace

ColourFidelity colourFidelity(const SpectralDistribution& source) {
  const auto test = appearances(source), reference = appearances(referenceFor(source));
  ColourFidelity result;
  double sum = 0;
  std::array<Cam02Ucs, 16> meanTest{}, meanReference{};
  std::array<int, 16> members{};
  for (std::size_t i = 0; i < test.size(); ++i) {
    const Cam02Ucs &t = test[i], &r = reference[i];
    const double difference = std::hypot(t.J - r.J, t.a - r.a, t.b - r.b);
    result.ofSample[i] = fidelity(difference);
    sum += difference;
    double hue = std::atan2(r.b, r.a) / (2 * std::numbers::pi);
    if (hue < 0) hue += 1;
    const std::size_t bin = std::min<std::size_t>(15, static_cast<std::size_t>(16 * hue));
    ++members[bin];
    meanTest[bin].a += t.a, meanTest[bin].b += t.b;
    meanReference[bin].a += r.a, meanReference[bin].b += r.b;
  }
  for (std::size_t bin = 0; bin < 16; ++bin) {
    if (members[bin] == 0) continue;  // does not happen with the standard's references
    for (auto* mean : {&meanTest[bin], &meanReference[bin]}) mean->a /= members[bin], mean->b /= members[bin];
    const auto &t = meanTest[bin], &r = meanReference[bin];
    const double chroma = std::hypot(r.a, r.b), angle = std::atan2(r.b, r.a);
    // Change along the hue at the middle of the bin, relative to the reference's chroma — TM-30-20, 3.5.
    const double middle = (static_cast<double>(bin) + 0.5) * std::numbers::pi / 8;
    result.chromaShift[bin] = ((t.a - r.a) * std::cos(middle) + (t.b - r.b) * std::sin(middle)) / chroma;
    result.hueAngle[bin] = angle * 180 / std::numbers::pi + (angle < 0 ? 360 : 0);
  }
  result.rf = fidelity(sum / static_cast<double>(test.size()));
  result.rg = 100 * area(meanTest) / area(meanReference);
  return result;
}

}  // namespace goniolux::spectrum
