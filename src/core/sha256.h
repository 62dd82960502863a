// SHA-256 (FIPS 180-4), through OpenSSL: identifies the bytes of inputs, so that a result says what it was made from.
#pragma once

#include <string>
#include <string_view>

namespace goniolux::core {

/// Digest as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace goniolux::core
