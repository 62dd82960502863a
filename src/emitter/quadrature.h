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
inline constexpr std::array<GaussPoint, 3> gauss3{{{0.11270166537925831148, 0.27777777777777777778},
                                                   {0.5, 0.44444444444444444444},
                                                   {0.88729833462074168852, 0.27777777777777777778}}};
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

/// Of the difference to a rule that is coarser by two.
inline constexpr double coarserShare = 0.3;

template <typename F>
QuadratureResult integrateCell(const F& f, const core::Vec2& low, double size, double allowed, int depth) {
  // Where f has a kink (tables have one at every angle), the rules err by similar amounts; that two differences are
  // both small by chance is rare. Where f is smooth the estimate is far too careful.
  const double fine = gauss(gauss4, f, low, size);
  const double error = std::max(std::abs(fine - gauss(gauss3, f, low, size)),
                                coarserShare * std::abs(fine - gauss(gauss2, f, low, size)));
  if (error <= allowed || depth == 0) return {fine, error};
  QuadratureResult total;
  const double half = 0.5 * size;
  for (int i = 0; i < 4; ++i) {
    const QuadratureResult part =
        integrateCell(f, {low.x + (i & 1) * half, low.y + (i >> 1) * half}, half, 0.5 * allowed, depth - 1);
    total.value += part.value;
    total.bound += part.bound;
  }
  return total;
}

inline constexpr int deepest = 6;  // 4^6 cells
inline constexpr int mostRounds = 3;

}  // namespace detail

/// Integral over the unit square of an f that is nowhere below 0, to about `tolerance` of itself, by at most 4^6 cells.
/// `flat`: f hardly changes over the square, so that fourteen points are tried first.
template <typename F>
QuadratureResult integrateSquare(const F& f, double tolerance, bool flat = false) {
  if (flat) {
    const double fine = detail::gauss(detail::gauss3, f, {0, 0}, 1);
    const double error = std::max(std::abs(fine - detail::gauss(detail::gauss2, f, {0, 0}, 1)),
                                  detail::coarserShare * std::abs(fine - f(core::Vec2(0.5, 0.5))));
    if (fine > 0 && error <= tolerance * fine) return {fine, error};
  }
  double rough = detail::gauss(detail::gauss4, f, {0, 0}, 1);
  if (rough == 0) {
    // Perhaps a small lit part between the points: look once with finer cells.
    const QuadratureResult found = detail::integrateCell(f, {0, 0}, 1, -1.0, 3);
    if (found.value == 0) return found;
    rough = found.value;
  }
  QuadratureResult result;
  for (int round = 0; round < detail::mostRounds; ++round) {
    result = detail::integrateCell(f, {0, 0}, 1, tolerance * rough, detail::deepest);
    if (result.value >= 0.5 * rough) break;  // else the rough value met a peak, and allowed too much
    rough = result.value;
  }
  return result;
}

}  // namespace goniolux::emitter
