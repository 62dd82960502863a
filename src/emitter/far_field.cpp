// The far field of an opening: one sample at its centre, where a bound says that it is enough.
//
// Of an element at x from the centre (|x| at most R) the point gets f(x) = I(x) g(x), g = cosine / distance^2. With
// alpha = R / distance, f is expanded about the centre; what is odd in x cancels in the mean over the opening, which is
// the same on both sides of its centre. What is left is bounded: by the even part of g, by the even part of I, and by
// the product of their first differences (docs/methods/photometry.md, near field).
#include <cmath>

#include "emitter/opening_emitter.h"

namespace goniolux::emitter {

using core::Vec3;

namespace {

constexpr double largestAlpha = 0.1;  // beyond it the expansion is not worth its bounds
constexpr double higherOrders = 1.3;  // of alpha up to largestAlpha, over the second
constexpr double meanSquare = 0.5;    // of |x| / R: 1/2 over a disc, 1/3 over a rectangle or a line

}  // namespace

std::optional<Illuminance> OpeningEmitter::fromCentre(const Vec3& point, const Vec3& normal, double tolerance) const {
  if (!isCentred() || !output_.distribution) return std::nullopt;
  const Vec3 toCentre = center_ - point;
  const double distance = glm::length(toCentre);
  if (!(boundingRadius_ < largestAlpha * distance)) return std::nullopt;
  const double alpha = boundingRadius_ / distance;
  const double cosine = glm::dot(toCentre, normal) / distance;
  if (cosine <= -alpha) return Illuminance{};
  if (cosine <= 2 * alpha) return std::nullopt;  // the receiver's plane cuts the opening, or nearly so
  const double even = meanSquare * higherOrders * alpha * alpha * (6 + 3 / cosine);
  if (even > tolerance) return std::nullopt;
  const double first = (1 + alpha / cosine) / std::pow(1 - alpha, 3) - 1;
  const Vec3 local = output_.frame.toLocal(-toCentre / distance);
  const auto change = output_.distribution->variation(local, std::asin(alpha));
  if (!change) return std::nullopt;
  const double candelas = output_.distribution->intensity(local);
  // The mean over the opening of what grows with |x| is below its value at R times the root of meanSquare.
  const double error = candelas * even + std::sqrt(meanSquare) * change->even + meanSquare * change->first * first;
  if (error > tolerance * candelas) return std::nullopt;
  const double perCandela = output_.scale * cosine / (distance * distance);
  return Illuminance{perCandela * candelas, perCandela * error};
}

}  // namespace goniolux::emitter
