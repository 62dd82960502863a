#include "plot/grid_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace goniolux::plot {
namespace {

/// Fritsch & Butland's slope at a point between two differences, for equal spacing: their harmonic mean, 0 at an
/// extremum.
double slope(double before, double after) {
  return before * after > 0 ? 2 * before * after / (before + after) : 0;
}

/// Cubic between y1 and y2 at t in [0, 1]; y0 and y3 are the neighbours, where there are any.
double monotoneCubic(double y0, double y1, double y2, double y3, bool hasBefore, bool hasAfter, double t) {
  const double d = y2 - y1;
  const double m1 = hasBefore ? slope(y1 - y0, d) : d;
  const double m2 = hasAfter ? slope(d, y3 - y2) : d;
  const double t2 = t * t, t3 = t2 * t;
  return y1 * (2 * t3 - 3 * t2 + 1) + m1 * (t3 - 2 * t2 + t) + y2 * (3 * t2 - 2 * t3) + m2 * (t3 - t2);
}

/// The curve through `count` equally spaced values at position x (in steps); beyond the ends, the end's slope goes on.
template <typename ValueAt>
double along(int count, double x, ValueAt valueAt) {
  if (count == 1) return valueAt(0);
  const int i = std::clamp(static_cast<int>(std::floor(x)), 0, count - 2);
  if (x < 0) return valueAt(0) + x * (valueAt(1) - valueAt(0));
  if (x > count - 1) return valueAt(count - 1) + (x - (count - 1)) * (valueAt(count - 1) - valueAt(count - 2));
  const bool hasBefore = i > 0, hasAfter = i + 2 < count;
  return monotoneCubic(hasBefore ? valueAt(i - 1) : 0, valueAt(i), valueAt(i + 1), hasAfter ? valueAt(i + 2) : 0,
                       hasBefore, hasAfter, x - i);
}

/// Replaces NaN by the mean of the neighbours that are known, ring by ring.
void fillUnknown(int nu, int nv, std::vector<double>& values) {
  const auto at = [nu](int i, int j) { return static_cast<std::size_t>(j * nu + i); };
  bool unknown = true;
  while (unknown) {
    unknown = false;
    std::vector<double> next = values;
    for (int j = 0; j < nv; ++j) {
      for (int i = 0; i < nu; ++i) {
        if (!std::isnan(values[at(i, j)])) continue;
        double sum = 0;
        int count = 0;
        for (int y = std::max(j - 1, 0); y <= std::min(j + 1, nv - 1); ++y) {
          for (int x = std::max(i - 1, 0); x <= std::min(i + 1, nu - 1); ++x) {
            if (std::isnan(values[at(x, y)])) continue;
            sum += values[at(x, y)];
            ++count;
          }
        }
        if (count > 0) {
          next[at(i, j)] = sum / count;
        } else {
          unknown = true;
        }
      }
    }
    values = std::move(next);
  }
}

}  // namespace

GridField::GridField(int nu, int nv, std::vector<double> values) : nu_(nu), nv_(nv), values_(std::move(values)) {
  assert(values_.size() == static_cast<std::size_t>(nu_ * nv_));
  excluded_.reserve(values_.size());
  for (const double value : values_) excluded_.push_back(std::isnan(value));
  assert(std::find(excluded_.begin(), excluded_.end(), false) != excluded_.end());
  fillUnknown(nu_, nv_, values_);
  const auto [low, high] = std::minmax_element(values_.begin(), values_.end());
  lowest_ = *low;
  highest_ = *high;
}

double GridField::at(double a, double b) const {
  const double x = std::clamp(a, 0.0, 1.0) * nu_ - 0.5, y = std::clamp(b, 0.0, 1.0) * nv_ - 0.5;
  const auto value = [this](int column, int row) {
    return values_[static_cast<std::size_t>(std::clamp(row, 0, nv_ - 1) * nu_ + std::clamp(column, 0, nu_ - 1))];
  };
  const int j = std::clamp(static_cast<int>(std::floor(y)), 0, std::max(nv_ - 2, 0));
  double row[4];
  for (int k = 0; k < 4; ++k) {
    const int r = j - 1 + k;
    row[k] = along(nu_, x, [&](int column) { return value(column, r); });
  }
  const double result = along(nv_, y, [&](int r) { return row[r - j + 1]; });
  return std::clamp(result, lowest_, highest_);
}

bool GridField::isExcluded(double a, double b) const {
  const int i = std::clamp(static_cast<int>(std::floor(a * nu_)), 0, nu_ - 1);
  const int j = std::clamp(static_cast<int>(std::floor(b * nv_)), 0, nv_ - 1);
  return excluded_[static_cast<std::size_t>(j * nu_ + i)];
}

}  // namespace goniolux::plot
