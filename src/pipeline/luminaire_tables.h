// The second page of the luminaire sheet (`--sheet full`): spacing criterion, utilisation factors, UGR table, and how
// near the paper's goniometric diagrams come to the full table.
#pragma once

#include <string>

#include "core/document.h"
#include "photometry/photometric_file.h"

namespace goniolux::pipeline {

/// Members added to the file's entry: spacing_criterion, diagrams, utilisation, ugr.
void addTables(const photometry::PhotometricFile& file, core::Value& document);

/// The same as text.
std::string tablesText(const photometry::PhotometricFile& file);

}  // namespace goniolux::pipeline
