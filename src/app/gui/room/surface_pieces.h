// Surface pieces: the objects of a scene as triangles for the 3-D view, cut into pieces that a slow machine draws
// within a moment each: the largest objects first. World frame of the project, metres.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "core/vector.h"
#include "geometry/shape.h"
#include "pipeline/feature_edges.h"
#include "plot/palette.h"

namespace goniolux::gui {

/// About so much does software OpenGL draw in some ten milliseconds.
inline constexpr std::size_t trianglesOfPiece = 24000, linesOfPiece = 24000, linesOfFirstPiece = 3000;

/// Point scalars: colours; cell array "object": the object's number.
struct SurfacePiece {
  vtkSmartPointer<vtkPolyData> data;
  bool isClosed = false;  ///< only fronts can be seen
};

class SurfaceList {
 public:
  /// `turned`: the triangles' fronts are their backs. Colours by part.
  void add(const geometry::Mesh& mesh, const core::Mat4& place, bool turned, const std::vector<plot::Rgb>& colourOfPart,
           int object);
  /// All in one piece.
  [[nodiscard]] vtkSmartPointer<vtkPolyData> whole() const;
  /// The largest first; those of a size in a mixed order, so that a part of a field of chairs lies all over it.
  [[nodiscard]] std::vector<SurfacePiece> pieces() const;

 private:
  struct Shape {
    geometry::Mesh mesh;
    std::vector<plot::Rgb> colourOfPart;
    bool isClosed = false;
  };
  struct Place {
    std::size_t shape = 0;
    core::Mat4 place{1.0};
    bool turned = false;
    int object = 0;
    double size = 0;
  };
  std::vector<Shape> shapes_;
  std::vector<Place> places_;
};

/// Lines in pieces: first those of the largest objects, as they were given.
std::vector<vtkSmartPointer<vtkPolyData>> linePieces(const std::vector<pipeline::Segment>& segments);

}  // namespace goniolux::gui
