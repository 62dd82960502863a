// Writes a figure as a picture.
#pragma once

#include <string>
#include <vector>

#include "core/document.h"

namespace goniolux::plot {

/// Draws the figure that the document describes into each of the files; their endings (.png, .svg) say how. Throws
/// core::InputError on a document that is no figure, CannotDraw where there is no OpenGL, core::RunError where a file
/// cannot be written.
void drawFigure(const core::Value& document, const std::vector<std::string>& files);

}  // namespace goniolux::plot
