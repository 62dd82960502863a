// The luminaire sheet: what a photometric file says and what follows from it, as a document and as text for a terminal.
#pragma once

#include <string>

#include "core/document.h"
#include "photometry/photometric_file.h"

namespace goniolux::pipeline {

/// One entry of `luminaire --json`.
core::Value luminaireDocument(const photometry::PhotometricFile& file);

/// The same for a reader, aligned, lines below 120 columns where messages allow.
std::string luminaireText(const photometry::PhotometricFile& file);

/// "rectangle", "disc", "ellipse" …
const char* shapeName(const photometry::StatedOpening& opening);

/// "rectangle, 1.2 m along C0, 0.3 m along C90".
std::string openingText(const photometry::StatedOpening& opening);

}  // namespace goniolux::pipeline
