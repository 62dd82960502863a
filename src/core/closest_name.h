// closestName: the known name that a mistyped one most likely meant, for error messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace goniolux::core {

/// The known name with the smallest edit distance (insert, delete, change, swap of neighbours; case ignored); "" when
/// none is near: more than half of the letters would have to change.
std::string closestName(std::string_view name, const std::vector<std::string>& known);

/// "; did you mean 'X'?" or, when no known name is near, "; known: A, B, C" ("" when nothing is known).
std::string suggestion(std::string_view name, const std::vector<std::string>& known);

}  // namespace goniolux::core
