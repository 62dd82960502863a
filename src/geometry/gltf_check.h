// What must hold of a glTF file before the importer library may see it: it trusts node trees and counts.
#pragma once

#include <string>

namespace goniolux::geometry {

/// Throws std::invalid_argument with what is wrong: no JSON, nodes in a circle or with two parents, indices that name
/// nothing, accessors beyond their buffer views and views beyond their buffers, more than 20 million vertices or
/// indices in an accessor. — glTF 2.0 specification, 3.5.2 (strict trees), 3.6
void checkGltf(const std::string& path);

}  // namespace goniolux::geometry
