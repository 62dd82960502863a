// The section "views" of a project: the viewing and image parameters of its pictures.
#pragma once

#include <vector>

#include "core/document.h"
#include "project/reading.h"
#include "scene/view.h"

namespace goniolux::project {

std::vector<scene::View> readViews(const core::Value& section, Reading& reading);

/// Vertical field of view for a horizontal one, both whole angles in radians, on an image of `width` x `height` square
/// pixels.
double verticalField(double horizontal, scene::View::Projection projection, int width, int height);

}  // namespace goniolux::project
