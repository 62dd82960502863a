// Ink: lines, areas and words on a page through vtkContext2D, the same for pixels and for SVG. Pixels, y up; colours
// sRGB.
#pragma once

#include <string>

#include "core/vector.h"
#include "plot/figure.h"
#include "plot/palette.h"

class vtkContext2D;
class vtkImageData;
class vtkTextProperty;

namespace goniolux::plot {

inline constexpr Rgb black{0x1a, 0x1a, 0x1a}, white{0xff, 0xff, 0xff}, grey{0x6a, 0x6a, 0x6a},
    paleGrey{0xd0, 0xd0, 0xd0};

struct TextStyle {
  int size = 16;  ///< pixels
  bool bold = false;
  Rgb colour = black;
  double angle = 0;  ///< rad, anticlockwise
  double halo = 0;   ///< pixels of white around the letters
  enum class Align { left, center, right } align = Align::left;
};

class Ink {
 public:
  explicit Ink(vtkContext2D& context) : context_(context) {}

  void line(const Polyline& points, const Rgb& colour, double width, int opacity = 255);
  void area(const Polyline& corners, const Rgb& colour, int opacity = 255);
  void rectangle(const core::Vec2& low, const core::Vec2& high, const Rgb& colour, int opacity = 255);
  /// `at` is the left end, middle or right end (as aligned) of the line halfway up a capital letter.
  void text(const std::string& words, const core::Vec2& at, const TextStyle& style);
  void image(const core::Vec2& low, const core::Vec2& high, vtkImageData* image);

 private:
  vtkContext2D& context_;
};

/// Width of the words and height of a capital letter, pixels.
core::Vec2 textSize(const std::string& words, const TextStyle& style);

}  // namespace goniolux::plot
