// QtInk: the paper of the plots, painted by Qt: on the screen, into a picture, or into a PDF.
#pragma once

#include <QPainter>

#include "plot/vtk/ink.h"

namespace goniolux::gui {

class QtInk final : public plot::Ink {
 public:
  /// `height`: of the page in its own pixels; the painter's coordinates are those, y down.
  QtInk(QPainter& painter, int height);
  void line(const plot::Polyline& points, const plot::Rgb& colour, double width, int opacity) override;
  void area(const plot::Polyline& corners, const plot::Rgb& colour, int opacity) override;
  void text(const std::string& words, const core::Vec2& at, const plot::TextStyle& style) override;
  void image(const core::Vec2& low, const core::Vec2& high, vtkImageData* image) override;

 private:
  [[nodiscard]] QPolygonF polygon(const plot::Polyline& points) const;
  QPainter& painter_;
  int height_;
};

}  // namespace goniolux::gui
