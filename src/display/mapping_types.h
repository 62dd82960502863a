// The makers of the registry's entries, one per file. To add a mapping: write its file, declare its maker here, and
// list it in mappings.cpp.
#pragma once

#include "display/mapping.h"

namespace goniolux::display {

MappingType linearMapping();
MappingType absoluteMapping();
MappingType tumblinRushmeierMapping();
MappingType wardMapping();
MappingType reinhardMapping();
MappingType falseColourMapping();

/// Descriptions of parameters, as the registry's entries give them. `standard`: as a user would write it.
core::Parameter mappingNumber(const char* key, const char* standard, double minimum, bool minimumIsAllowed,
                              const char* help);
core::Parameter mappingText(const char* key, const char* standard, const char* help);
core::Parameter mappingSwitch(const char* key, const char* help);

}  // namespace goniolux::display
