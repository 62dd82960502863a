// TransferCurve: between the code value of a channel and the light that it gives.
#pragma once

#include <vector>

namespace goniolux::display {

/// From linear light L (1: the device's white) to code value V (0..1).
struct TransferCurve {
  enum class Form {
    power,  ///< V = slope L up to `threshold`, above it V = (1 + offset) L^(1/gamma) - offset; a pure power has slope,
            ///< threshold and offset 0
    pq,     ///< SMPTE ST 2084: absolute luminance, up to 10 000 cd/m2
    table,  ///< light at code values in equal steps from 0 to 1, ascending, joined by straight lines
  };
  Form form = Form::power;
  double gamma = 1, offset = 0, slope = 0, threshold = 0;
  double white_cd_m2 = 0;     ///< pq: the luminance of L = 1
  std::vector<double> light;  ///< table

  [[nodiscard]] double encode(double linear) const;
  [[nodiscard]] double decode(double code) const;

  friend bool operator==(const TransferCurve&, const TransferCurve&) = default;
};

}  // namespace goniolux::display
