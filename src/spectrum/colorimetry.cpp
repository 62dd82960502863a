#include "spectrum/colorimetry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "spectrum/cie_data.h"
#include "spectrum/hats.h"
#include "spectrum/product_integral.h"

namespace goniolux::spectrum {
namespace {

constexpr double largestSummedStep = 5;  // nm: the coarsest steps for which CIE 015 sums without interpolating first

// Integral of source x reflectance x observer's function, by the rule of the header.
double response(const SpectralDistribution& source, const SpectralDistribution& reflectance, double step,
                const SpectralDistribution& observer) {
  if (step == 0) {
    return integralOfProduct({&source, &observer, &reflectance}, visibleFrom, visibleTo);
  }
  double sum = 0;
  for (const auto& [wavelength, power] : source.samples()) {
    sum += step * power * observer.continuum(wavelength) * reflectance.continuum(wavelength);
  }
  for (const auto& [wavelength, power] : source.lines()) {
    sum += power * observer.continuum(wavelength) * reflectance.continuum(wavelength);
  }
  return sum;
}

Xyz responses(const SpectralDistribution& source, const SpectralDistribution& reflectance, const Observer& observer) {
  const double step = summationStep(source);
  return {response(source, reflectance, step, observer.xbar), response(source, reflectance, step, observer.ybar),
          response(source, reflectance, step, observer.zbar)};
}

struct Uv1960 {
  double u, v;
};

Uv1960 uv1960(const Xyz& colour) {
  const auto [u, v] = uvPrime(colour);
  return {u, v * 2 / 3};
}

double distance(const Uv1960& a, const Uv1960& b) {
  return std::hypot(a.u - b.u, a.v - b.v);
}

Uv1960 planckian(double mired) {
  return uv1960(tristimulus(blackbody(1e6 / mired)));
}

}  // namespace

double summationStep(const SpectralDistribution& source) {
  const auto samples = source.samples();
  if (samples.size() < 3) return 0;
  const double step = samples[1].wavelength - samples[0].wavelength;
  if (step > largestSummedStep) return 0;
  for (std::size_t i = 2; i < samples.size(); ++i) {
    if (std::abs(samples[i].wavelength - samples[i - 1].wavelength - step) > 1e-6) return 0;
  }
  return step;
}

Xyz tristimulus(const SpectralDistribution& source, const Observer& observer) {
  return responses(source, SpectralDistribution::flat(1), observer);
}

Xyz tristimulus(const SpectralDistribution& source) {
  return tristimulus(source, cie1931());
}

Xyz tristimulus(const SpectralDistribution& reflectance, const SpectralDistribution& source, const Observer& observer) {
  const auto [X, Y, Z] = responses(source, reflectance, observer);
  const double white = tristimulus(source, observer).Y;
  return {X / white, Y / white, Z / white};
}

Xyz tristimulus(const SpectralDistribution& reflectance, const SpectralDistribution& source) {
  return tristimulus(reflectance, source, cie1931());
}

double alphaOpicDer(const SpectralDistribution& source, AlphaOpic response) {
  const double perLumen = 1000 * source.integral(alphaOpicAction(response)) /
                          (maximumLuminousEfficacy * source.integral(cie1931().ybar));  // mW/lm
  return perLumen / alphaOpicEfficacyOfD65(response);
}

double melanopicDer(const SpectralDistribution& source) {
  return alphaOpicDer(source, AlphaOpic::melanopic);
}

double scotopicPhotopicRatio(const SpectralDistribution& source) {
  return maximumScotopicEfficacy * source.integral(scotopicEfficiency()) /
         (maximumLuminousEfficacy * source.integral(cie1931().ybar));
}

Chromaticity chromaticity(const Xyz& colour) {
  const double sum = colour.X + colour.Y + colour.Z;
  if (!(sum > 0)) return {};
  return {colour.X / sum, colour.Y / sum};
}

UvPrime uvPrime(const Xyz& colour) {
  const double sum = colour.X + 15 * colour.Y + 3 * colour.Z;
  if (!(sum > 0)) return {};
  return {4 * colour.X / sum, 9 * colour.Y / sum};
}

ColourTemperature colourTemperature(const Xyz& colour) {
  constexpr double hottest = 1, coldest = 2000,
                   step = 10;  // mired (10^6 K / T): steps along the locus are of similar length
  struct Point {
    double mired;
    Uv1960 uv;
  };
  static const std::vector<Point> locus = [] {
    std::vector<Point> points;
    for (double mired = hottest; mired < coldest; mired += step) points.push_back({mired, planckian(mired)});
    points.push_back({coldest, planckian(coldest)});
    return points;
  }();
  const Uv1960 target = uv1960(colour);
  const auto nearest = std::min_element(locus.begin(), locus.end(), [&](const Point& a, const Point& b) {
    return distance(a.uv, target) < distance(b.uv, target);
  });
  double low = nearest == locus.begin() ? hottest : (nearest - 1)->mired;
  double high = nearest + 1 == locus.end() ? coldest : (nearest + 1)->mired;
  // Golden section search: the distance has one minimum between the neighbours of the nearest point.
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double atA = distance(planckian(a), target), atB = distance(planckian(b), target);
  while (high - low > 1e-7 * low) {
    if (atA < atB) {
      high = b, b = a, atB = atA;
      a = high - golden * (high - low);
      atA = distance(planckian(a), target);
    } else {
      low = a, a = b, atA = atB;
      b = low + golden * (high - low);
      atB = distance(planckian(b), target);
    }
  }
  const double mired = (low + high) / 2;
  const Uv1960 foot = planckian(mired);
  // Off the locus towards green v is above the foot of the perpendicular, towards magenta below.
  const double side = target.v >= foot.v ? 1 : -1;
  return {1e6 / mired, side * distance(foot, target)};
}

}  // namespace goniolux::spectrum
