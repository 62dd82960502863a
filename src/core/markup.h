// Markup: text made safe inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace goniolux::core {

/// `&`, `<`, `>` and quotes as entities; control characters that XML forbids become spaces.
std::string escapedMarkup(std::string_view text);

}  // namespace goniolux::core
