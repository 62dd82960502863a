#include "reflection/fresnel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace goniolux::reflection {
namespace {

// 2 integral of R(mu) mu dmu over 0..1 by the midpoint rule in mu^2; R varies fastest at grazing, where mu^2 is dense.
template <typename Reflectance>
double diffuseMean(const Reflectance& reflectance) {
  constexpr int steps = 2048;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += reflectance(std::sqrt((i + 0.5) / steps));
  return sum / steps;
}

}  // namespace

double refractedCosine(double cosine, double relativeIndex) {
  const double sineSquared = (1 - cosine * cosine) / (relativeIndex * relativeIndex);
  return sineSquared >= 1 ? 0 : std::sqrt(1 - sineSquared);
}

PolarisedReflectance dielectricReflectance(double cosine, double relativeIndex) {
  const double refracted = refractedCosine(cosine, relativeIndex);
  if (refracted == 0 && relativeIndex < 1) return {1, 1};  // total internal reflection
  if (cosine <= 0) return {1, 1};
  const double s = (cosine - relativeIndex * refracted) / (cosine + relativeIndex * refracted);
  const double p = (relativeIndex * cosine - refracted) / (relativeIndex * cosine + refracted);
  return {s * s, p * p};
}

PolarisedReflectance conductorReflectance(double cosine, double n, double k) {
  using Complex = std::complex<double>;
  if (cosine <= 0) return {1, 1};
  const Complex index(n, k);
  const Complex refracted = std::sqrt(1.0 - (1 - cosine * cosine) / (index * index));
  const Complex s = (cosine - index * refracted) / (cosine + index * refracted);
  const Complex p = (index * cosine - refracted) / (index * cosine + refracted);
  return {std::norm(s), std::norm(p)};
}

Slab slab(double cosine, double relativeIndex, double attenuation, double thickness) {
  const PolarisedReflectance face = dielectricReflectance(cosine, relativeIndex);
  const double refracted = refractedCosine(cosine, relativeIndex);
  if (refracted <= 0) return {1, 0};
  const double inside = std::exp(-attenuation * thickness / refracted);
  Slab mean;
  for (const double r : {face.s, face.p}) {
    // r + (1-r)^2 r a^2 (1 + r^2 a^2 + ...), (1-r)^2 a (1 + r^2 a^2 + ...)
    const double series = (1 - r) * (1 - r) / std::max(1e-300, 1 - r * r * inside * inside);
    if (r >= 1) {
      mean.reflectance += 0.5;
      continue;
    }
    mean.reflectance += 0.5 * (r + series * r * inside * inside);
    mean.transmittance += 0.5 * series * inside;
  }
  return mean;
}

double diffuseDielectricReflectance(double relativeIndex) {
  return diffuseMean([&](double mu) { return dielectricReflectance(mu, relativeIndex).mean(); });
}

double diffuseConductorReflectance(double n, double k) {
  return diffuseMean([&](double mu) { return conductorReflectance(mu, n, k).mean(); });
}

}  // namespace goniolux::reflection
