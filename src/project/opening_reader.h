// The key "shape" of a luminaire: its luminous opening, stated in the project or taken from the photometric file.
#pragma once

#include <optional>

#include "core/document.h"
#include "emitter/opening.h"
#include "photometry/photometric_file.h"
#include "project/reading.h"

namespace goniolux::project {

/// The opening that a photometric file states, in the luminaire frame: LM-63 lays the length along C0, EULUMDAT along
/// C90.
emitter::Opening openingOf(const photometry::StatedOpening& stated);

/// `shape`: the value of the key, or nullptr for "auto"; `file`: the luminaire's photometric file, or nullptr for
/// built-in photometry, which is a point unless a shape is given; `frame`: the luminaire's, for a line along C0 or C90.
std::optional<emitter::Opening> readOpening(const core::Value* shape, const photometry::PhotometricFile* file,
                                            const photometry::LuminaireFrame& frame, Reading& reading);

/// True when light can leave its surface: everything but a point and a line.
bool hasSurface(const emitter::Opening& opening);

}  // namespace goniolux::project
