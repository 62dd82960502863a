// Reads a .vtp file with VTK's own reader: proof that the files written without VTK are what VTK understands.
#pragma once

#include <string>

#include "core/document.h"

namespace goniolux::plot {

/// Points, arrays (by name) and the numbers of vertices, lines and polygons. Throws core::InputError if VTK cannot read
/// the file.
core::Value readBackVtp(const std::string& file);

}  // namespace goniolux::plot
