// Zip: several named byte strings as one ZIP archive, stored and not compressed. For document formats that are archives
// (OpenDocument); their readers unpack any of them.
// Source: PKWARE APPNOTE 6.3.3, 4.3 (local headers, central directory, end record).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace goniolux::core {

/// The archive of `entries` (path with '/', content) in their order. Dates are 1980-01-01, so that equal content gives
/// equal bytes. Each content and the whole must be below 4 GiB.
std::string zipArchive(const std::vector<std::pair<std::string, std::string>>& entries);

/// CRC-32 of ISO 3309 as ZIP and PNG use it.
std::uint32_t crc32(std::string_view bytes);

}  // namespace goniolux::core
