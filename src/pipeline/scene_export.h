// The scene for other programs, so that a second opinion is one command away: Radiance files, and glTF for modellers.
// Both return the files' names and bytes; what the other program cannot say goes into `left` as warnings.
#pragma once

#include <map>
#include <string>

#include "core/diagnostics.h"
#include "project/project.h"

namespace goniolux::pipeline {

using FileContents = std::map<std::string, std::string>;  ///< by file name

/// scene.rad with materials, surfaces and luminaires (a `light` with the pattern intensity / projected area), a table
/// and a .cal file per luminaire, a .pts file per grid, a .vf file per view, and calculate.sh. Three channels are three
/// bands of the first lamp's spectrum with a third of its luminous flux each; values are cd/m2 and lx instead of watts,
/// and an illuminance is the sum of the channels. Frame and metres are those of the project.
FileContents radianceFiles(const project::Project& project, core::Diagnostics& left);

/// NAME.glb: glTF 2.0, metres, y up by its root node. Curved surfaces as triangles; finishes by their colour under D65;
/// luminaires as their openings and as point lights of the same flux (KHR_lights_punctual).
FileContents gltfFile(const project::Project& project, const std::string& name, core::Diagnostics& left);

}  // namespace goniolux::pipeline
