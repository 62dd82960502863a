#include "display/transfer_curve.h"

#include <algorithm>
#include <cmath>

namespace goniolux::display {
namespace {

// SMPTE ST 2084: y = luminance over 10 000 cd/m2.
constexpr double m1 = 2610.0 / 16384, m2 = 2523.0 / 32, c1 = 3424.0 / 4096, c2 = 2413.0 / 128, c3 = 2392.0 / 128;
constexpr double pqPeak_cd_m2 = 10000;

double pqEncode(double y) {
  const double p = std::pow(std::clamp(y, 0.0, 1.0), m1);
  return std::pow((c1 + c2 * p) / (1 + c3 * p), m2);
}

double pqDecode(double code) {
  const double p = std::pow(std::clamp(code, 0.0, 1.0), 1 / m2);
  return std::pow(std::max(p - c1, 0.0) / (c2 - c3 * p), 1 / m1);
}

}  // namespace

double TransferCurve::encode(double linear) const {
  switch (form) {
    case Form::pq:
      return pqEncode(linear * white_cd_m2 / pqPeak_cd_m2);
    case Form::table: {
      const auto above = std::upper_bound(light.begin(), light.end(), linear);
      if (above == light.begin()) return 0;
      if (above == light.end()) return 1;
      const auto i = static_cast<double>(above - light.begin() - 1);
      const double low = *(above - 1), high = *above;
      return (i + (linear - low) / (high - low)) / static_cast<double>(light.size() - 1);
    }
    default:
      if (linear <= threshold) return threshold > 0 ? slope * linear : 0;
      return (1 + offset) * std::pow(linear, 1 / gamma) - offset;
  }
}

double TransferCurve::decode(double code) const {
  switch (form) {
    case Form::pq:
      return pqDecode(code) * pqPeak_cd_m2 / white_cd_m2;
    case Form::table: {
      const double at = std::clamp(code, 0.0, 1.0) * static_cast<double>(light.size() - 1);
      const auto i = std::min(static_cast<std::size_t>(at), light.size() - 2);
      return light[i] + (at - static_cast<double>(i)) * (light[i + 1] - light[i]);
    }
    default:
      if (code <= slope * threshold) return slope > 0 ? code / slope : 0;
      return std::pow((code + offset) / (1 + offset), gamma);
  }
}

}  // namespace goniolux::display
