// The JSON Schema of the project file, made from the tables that the reader uses (format.h).
#pragma once

#include "core/document.h"

namespace goniolux::project {

/// Draft 2020-12. What the format knows but this version refuses as "not supported yet" is valid by the schema.
core::Value projectSchema();

}  // namespace goniolux::project
