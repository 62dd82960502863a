// Feature edges: the lines by which a person recognises an object in a drawing.
//
// Of triangles: boundary edges, edges where the surface bends by more than 20 degrees, and, for rounded meshes, the
// silhouette seen from straight above. Of quadric patches: rims, and the exact silhouette seen from above. World frame,
// metres.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/vector.h"
#include "scene/environment.h"

namespace goniolux::pipeline {

struct Segment {
  core::Vec3 from{0}, to{0};
};

/// The edges of one object, transformed to the world. At most 20 000; of more, the longest are kept.
std::vector<Segment> featureEdges(const scene::Object& object);

using Triangle = std::array<core::Vec3, 3>;

/// The object's surface as triangles in the world (patches as 48-sided approximations): what hides lines in a plan.
std::vector<Triangle> coveringTriangles(const scene::Object& object);

/// What hides lines in a plan, looked at from straight above.
class PlanCovers {
 public:
  explicit PlanCovers(std::vector<Triangle> covers);
  ~PlanCovers();

  /// What is left of `segments`: the parts under a cover are cut away, and so is what shows as a mere point. Parts less
  /// than `tolerance` (m) below a cover stay.
  [[nodiscard]] std::vector<Segment> visible(const std::vector<Segment>& segments, double tolerance) const;

 private:
  class Index;
  std::vector<Triangle> covers_;
  std::unique_ptr<Index> index_;
};

}  // namespace goniolux::pipeline
