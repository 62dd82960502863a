#include "core/zip.h"

#include <array>
#include <cassert>

namespace goniolux::core {
namespace {

void put16(std::string& to, std::uint32_t value) {
  to += static_cast<char>(value & 0xff);
  to += static_cast<char>((value >> 8) & 0xff);
}

void put32(std::string& to, std::uint32_t value) {
  put16(to, value & 0xffff);
  put16(to, value >> 16);
}

constexpr std::uint32_t version = 20;             // 2.0: folders and stored files
constexpr std::uint32_t nameIsUtf8 = 1U << 11;    // general purpose bit 11
constexpr std::uint32_t firstDay = (1 << 5) | 1;  // 1980-01-01 in MS-DOS form

/// What local and central headers share: from the version needed to the length of the name.
std::string commonHeader(const std::string& name, const std::string& content) {
  std::string header;
  put16(header, version);
  put16(header, nameIsUtf8);
  put16(header, 0);  // stored
  put16(header, 0);  // time
  put16(header, firstDay);
  put32(header, crc32(content));
  put32(header, static_cast<std::uint32_t>(content.size()));
  put32(header, static_cast<std::uint32_t>(content.size()));
  put16(header, static_cast<std::uint32_t>(name.size()));
  put16(header, 0);  // no extra field
  return header;
}

}  // namespace

std::uint32_t crc32(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> made{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t c = i;
      for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320U ^ (c >> 1) : c >> 1;
      made[i] = c;
    }
    return made;
  }();
  std::uint32_t crc = 0xffffffffU;
  for (const char byte : bytes) crc = table[(crc ^ static_cast<unsigned char>(byte)) & 0xff] ^ (crc >> 8);
  return crc ^ 0xffffffffU;
}

std::string zipArchive(const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string archive, directory;
  for (const auto& [name, content] : entries) {
    assert(content.size() < 0xffffffffU && archive.size() < 0xffffffffU);
    const std::string common = commonHeader(name, content);
    put32(directory, 0x02014b50);
    put16(directory, version);  // made by, MS-DOS attributes
    directory += common;
    put16(directory, 0);  // comment
    put16(directory, 0);  // disk
    put16(directory, 0);  // internal attributes
    put32(directory, 0);  // external attributes
    put32(directory, static_cast<std::uint32_t>(archive.size()));
    directory += name;
    put32(archive, 0x04034b50);
    archive += common + name + content;
  }
  const auto start = static_cast<std::uint32_t>(archive.size());
  archive += directory;
  put32(archive, 0x06054b50);
  put16(archive, 0);
  put16(archive, 0);
  put16(archive, static_cast<std::uint32_t>(entries.size()));
  put16(archive, static_cast<std::uint32_t>(entries.size()));
  put32(archive, static_cast<std::uint32_t>(directory.size()));
  put32(archive, start);
  put16(archive, 0);
  return archive;
}

}  // namespace goniolux::core
