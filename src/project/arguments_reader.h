// Arguments of a registry entry, read from the keys of a section as the entry describes them.
#pragma once

#include <optional>
#include <vector>

#include "core/parameter.h"
#include "project/section_reader.h"

namespace goniolux::project {

/// Every parameter that is given or has a default, checked and in SI; nothing when one was refused.
std::optional<core::Arguments> readArguments(SectionReader& section, const std::vector<core::Parameter>& parameters,
                                             Reading& reading);

}  // namespace goniolux::project
