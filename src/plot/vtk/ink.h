// Ink: lines, areas and words on a page. Pixels, y up; colours sRGB. Two kinds of paper: VTK's 2-D context for pixels,
// and SVG, which needs no OpenGL and keeps words as words. (VTK's own SVG exporter writes text a third too large,
// without weight or base line.)
#pragma once

#include <string>
#include <vector>

#include "core/vector.h"
#include "plot/figure.h"
#include "plot/palette.h"

class vtkContext2D;
class vtkImageData;

namespace goniolux::plot {

inline constexpr Rgb black{0x1a, 0x1a, 0x1a}, white{0xff, 0xff, 0xff}, grey{0x6a, 0x6a, 0x6a};

struct TextStyle {
  int size = 16;  ///< pixels
  bool bold = false;
  Rgb colour = black;
  double angle = 0;  ///< rad, anticlockwise
  enum class Align { left, center, right } align = Align::left;
};

/// Width of the words and height of a figure, pixels.
core::Vec2 textSize(const std::string& words, const TextStyle& style);

/// The style, smaller where the words would be wider than `width` (not below 10 pixels).
TextStyle fitting(const std::string& words, TextStyle style, double width);

class Ink {
 public:
  virtual ~Ink() = default;
  virtual void line(const Polyline& points, const Rgb& colour, double width, int opacity = 255) = 0;
  virtual void area(const Polyline& corners, const Rgb& colour, int opacity = 255) = 0;
  /// `at` is the left end, middle or right end (as aligned) of the line halfway up a figure.
  virtual void text(const std::string& words, const core::Vec2& at, const TextStyle& style) = 0;
  /// An RGBA picture, its first row at the bottom.
  virtual void image(const core::Vec2& low, const core::Vec2& high, vtkImageData* image) = 0;

  void rectangle(const core::Vec2& low, const core::Vec2& high, const Rgb& colour, int opacity = 255) {
    area({low, {high.x, low.y}, high, {low.x, high.y}}, colour, opacity);
  }
};

class ContextInk final : public Ink {
 public:
  explicit ContextInk(vtkContext2D& context) : context_(context) {}
  void line(const Polyline& points, const Rgb& colour, double width, int opacity) override;
  void area(const Polyline& corners, const Rgb& colour, int opacity) override;
  void text(const std::string& words, const core::Vec2& at, const TextStyle& style) override;
  void image(const core::Vec2& low, const core::Vec2& high, vtkImageData* image) override;

 private:
  vtkContext2D& context_;
};

class SvgInk final : public Ink {
 public:
  SvgInk(int width, int height, const std::string& title, const std::string& description);
  void line(const Polyline& points, const Rgb& colour, double width, int opacity) override;
  void area(const Polyline& corners, const Rgb& colour, int opacity) override;
  void text(const std::string& words, const core::Vec2& at, const TextStyle& style) override;
  void image(const core::Vec2& low, const core::Vec2& high, vtkImageData* image) override;
  /// The finished document.
  [[nodiscard]] std::string document() const { return svg_ + "</svg>\n"; }

 private:
  std::string pointList(const Polyline& points) const;
  int height_;
  std::string svg_;
};

/// The picture as the bytes of a PNG file; empty if VTK could not make it.
std::string pngOf(vtkImageData* image);

}  // namespace goniolux::plot
