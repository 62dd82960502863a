// A look through an OpenEXR header before the library reads it: the library asks for as much memory as a damaged header
// promises, and reads on by what a value should take, not by the size that the file states.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace goniolux::image {

constexpr int largestSide = 65536;  ///< pixels

/// core::InputError for sizes that so many bytes cannot hold.
void checkSize(std::int64_t width, std::int64_t height, std::size_t bytes, const std::string& path);

/// core::InputError when an attribute is longer than the file, does not have the size of its type, or the data window
/// is larger than the file can hold.
void checkExrHeader(std::string_view bytes, const std::string& path);

}  // namespace goniolux::image
