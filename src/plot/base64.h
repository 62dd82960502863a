// Base64 (RFC 4648): bytes as text inside XML.
#pragma once

#include <string>
#include <string_view>

namespace goniolux::plot {

std::string base64(std::string_view bytes);

}  // namespace goniolux::plot
