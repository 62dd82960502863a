// A view in words, as Radiance's programs write it in the headers of pictures: "-vta -vp 1 2 3 -vd 0 1 0 -vu 0 0 1 -vh
// 180 -vv 180". -vd's length is 1. Types: v perspective, l orthographic (-vh, -vv are lengths in metres), a equidistant
// fisheye; "e", which is ours, stands for the equisolid fisheye, which Radiance does not have.
#pragma once

#include <optional>
#include <string>

#include "scene/view.h"

namespace goniolux::scene {

std::string viewText(const View& view);

/// Whether Radiance and the programs for its pictures know this projection.
bool isKnownToRadiance(const View& view);

/// The view of such a text for an image of `width` x `height` pixels; nothing when it cannot be understood, or is
/// shifted, sliced or of another type.
std::optional<View> viewFromText(const std::string& text, int width, int height);

}  // namespace goniolux::scene
