// ColourScale: which colour a value has. Between two neighbouring levels lies the same stretch of the palette, whatever
// their distance, so that the steps of EN 12464-1, which grow with the value, are told apart everywhere.
#pragma once

#include <vector>

#include "plot/figure.h"
#include "plot/palette.h"

namespace goniolux::plot {

class ColourScale {
 public:
  explicit ColourScale(const PlanMap& map);

  /// Lowest value, levels inside the range, highest value: the edges of the legend's fields, ascending.
  [[nodiscard]] const std::vector<double>& edges() const { return edges_; }
  /// Where a value lies among the edges: 0 at the lowest, 1 at the highest (clamped); equal fields.
  [[nodiscard]] double fraction(double value) const;
  [[nodiscard]] Rgb colour(double value) const { return atFraction(fraction(value)); }
  /// Colour at a place of the legend; one colour per field if the figure is banded.
  [[nodiscard]] Rgb atFraction(double fraction) const;

 private:
  std::vector<double> edges_;
  std::vector<Rgb> colours_;  // one per field, or many for a smooth passage
};

}  // namespace goniolux::plot
