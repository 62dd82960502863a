// Feature edges: the lines by which a person recognises an object in a drawing.
//
// Of triangles: boundary edges, edges where the surface bends by more than 20 degrees, and, for rounded meshes, the
// silhouette seen from straight above. Of quadric patches: rims, and the exact silhouette seen from above. World frame,
// metres.
#pragma once

#include <array>
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

/// What is left of `segments` in a plan: looked at from straight above, the parts under one of `covers` are cut away,
/// and so is what shows as a mere point. Parts less than `tolerance` (m) below a cover stay.
std::vector<Segment> visibleFromAbove(const std::vector<Segment>& segments, const std::vector<Triangle>& covers,
                                      double tolerance);

}  // namespace goniolux::pipeline
