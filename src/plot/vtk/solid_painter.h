// SolidPainter: a photometric solid as a shaded surface in parallel projection. Drawn as areas from back to front, so
// that it comes out the same as pixels and as SVG.
#pragma once

#include "plot/photometric_solid.h"
#include "plot/vtk/ink.h"

namespace goniolux::plot {

class SolidPainter {
 public:
  /// The solid must outlive the painter.
  explicit SolidPainter(const PhotometricSolid& solid);
  [[nodiscard]] int width() const { return 1000; }
  [[nodiscard]] int height() const { return 960; }
  void paint(Ink& ink) const;

 private:
  [[nodiscard]] core::Vec3 corner(std::size_t plane, std::size_t gamma) const;
  /// Page position; z is the depth, larger = nearer.
  [[nodiscard]] core::Vec3 projected(const core::Vec3& point) const;
  void paintAxis(Ink& ink, const core::Vec3& direction, const char* name) const;

  const PhotometricSolid& solid_;
  double largest_ = 1, scale_ = 1;
  core::Vec2 origin_{0};
};

}  // namespace goniolux::plot
