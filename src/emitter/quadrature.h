// Adaptive Gauss quadrature over the unit square, with an error estimate.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/vector.h"

namespace goniolux::emitter {

struct QuadratureResult {
  double value = 0, bound = 0;
};

namespace detail {

// Abscissae and weights of Gauss-Legendre rules on [0, 1] (Abramowitz & Stegun, table 25.4).
struct GaussPoint {
  double x, w;
};
inline constexpr std::array<GaussPoint, 2> gauss2{{{0.21132486540518711775, 0.5}, {0.78867513459481288225, 0.5}}};
inline constexpr std::array<GaussPoint, 4> gauss4{{{0.06943184420297371239, 0.17392742256872692869},
                                                   {0.33000947820757186760, 0.32607257743127307131},
                                                   {0.66999052179242813240, 0.32607257743127307131},
                                                   {0.93056815579702628761, 0.17392742256872692869}}};

template <std::size_t N, typename F>
double gauss(const std::array<GaussPoint, N>& rule, const F& f, const core::Vec2& low, double size) {
  double sum = 0;
  for (const GaussPoint& a : rule)
    for (const GaussPoint& b : rule) sum += a.w * b.w * f(core::Vec2(low.x + size * a.x, low.y + size * b.x));
  return sum * size * size;
}

template <typename F>
QuadratureResult integrateCell(const F& f, const core::Vec2& low, double size, double allowed, int depth) {
  const double fine = gauss(gauss4, f, low, size), coarse = gauss(gauss2, f, low, size);
  const double error = std::abs(fine - coarse), half = 0.5 * size;
  if (error <= allowed || depth == 0) {
    // Both rules may step over the same kink of a table (a ring that the intensity falls off within: the error was 60
    // times the bound). So the 2-point rule on the four quarters must agree, too: of a smooth integrand its error is a
    // sixteenth of what was seen. The bound is a tenth of that, or twice what the quarters differ by (tests:
    // EmitterQuadrature_BoundHolds, case 31 of tests/stability).
    double quarters = 0;
    for (int i = 0; i < 4; ++i) quarters += gauss(gauss2, f, {low.x + (i & 1) * half, low.y + (i >> 1) * half}, half);
    const double apart = std::abs(quarters - fine);
    if (apart <= 0.1 * allowed || depth == 0) return {fine, std::max(0.1 * error, 2 * apart)};
  }
  QuadratureResult total;
  for (int i = 0; i < 4; ++i) {
    const QuadratureResult part =
        integrateCell(f, {low.x + (i & 1) * half, low.y + (i >> 1) * half}, half, 0.5 * allowed, depth - 1);
    total.value += part.value;
    total.bound += part.bound;
  }
  return total;
}

}  // namespace detail

/// Integral of f over the unit square to about `tolerance` of its size (relative to the integral of |f|), at most 4^6
/// cells.
template <typename F>
QuadratureResult integrateSquare(const F& f, double tolerance) {
  const double rough = detail::gauss(
      detail::gauss4, [&](const core::Vec2& u) { return std::abs(f(u)); }, {0, 0}, 1);
  if (rough == 0) {
    // Perhaps a small lit part between the points: look once with finer cells.
    return detail::integrateCell(f, {0, 0}, 1, -1.0, 3);
  }
  return detail::integrateCell(f, {0, 0}, 1, 10 * tolerance * rough, 6);
}

}  // namespace goniolux::emitter
