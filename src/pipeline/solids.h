// The closed objects of a project, for telling what lies inside them.
#pragma once

#include <vector>

#include "geometry/inside.h"
#include "project/project.h"

namespace goniolux::pipeline {

/// One test for each place of each closed object that does not face inward (rooms do). Project frame.
inline std::vector<geometry::InsideTest> solidsOf(const project::Project& project) {
  std::vector<geometry::InsideTest> solids;
  for (const scene::Object& object : project.environment.objects)
    if (object.shape.closed && !object.facesInward)
      for (const core::Mat4& place : scene::placesOf(object)) solids.emplace_back(object.shape, place);
  return solids;
}

}  // namespace goniolux::pipeline
