#include "image/exr_header_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/diagnostics.h"

namespace goniolux::image {
namespace {

// Types whose values take a fixed number of bytes (OpenEXR File Layout).
constexpr std::array<std::pair<std::string_view, std::size_t>, 21> sizes{
    {{"box2i", 16},      {"box2f", 16},   {"chromaticities", 32},
     {"compression", 1}, {"double", 8},   {"envmap", 1},
     {"float", 4},       {"int", 4},      {"keycode", 28},
     {"lineOrder", 1},   {"m33f", 36},    {"m44f", 64},
     {"m33d", 72},       {"m44d", 128},   {"rational", 8},
     {"tiledesc", 9},    {"timecode", 8}, {"v2i", 8},
     {"v2f", 8},         {"v3i", 12},     {"v3f", 12}}};

class Walker {
 public:
  Walker(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  // Each attribute is a name and a type, ended by zeros, a size in 4 bytes, and as many bytes; an empty name ends it.
  void walk() {
    at_ = 8;  // magic number and version
    for (std::string_view name = text(); !name.empty(); name = text()) {
      const std::string_view type = text();
      if (bytes_.size() - at_ < 4) damaged();
      const std::uint32_t size = number(at_);
      at_ += 4;
      if (size > bytes_.size() - at_) damaged();
      const auto known = std::find_if(sizes.begin(), sizes.end(), [&](const auto& each) { return each.first == type; });
      if (known != sizes.end() && known->second != size) damaged();
      if (type == "chlist") checkChannels(at_, at_ + size);
      if (type == "preview" && (size < 8 || 8 + 4.0 * number(at_) * number(at_ + 4) != size)) damaged();
      if (name == "dataWindow" && type == "box2i") checkSize(side(at_), side(at_ + 4), bytes_.size(), path_);
      at_ += size;
    }
  }

 private:
  [[noreturn]] void damaged() const {
    throw core::InputError({path_, 0, 0}, "damaged-image", "the header of the image is damaged; render it again");
  }
  std::string_view text() {
    const std::size_t end = bytes_.find('\0', at_);
    if (end == std::string_view::npos || end - at_ > 255) damaged();
    const std::string_view found = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return found;
  }
  [[nodiscard]] std::uint32_t number(std::size_t from) const {
    std::uint32_t value = 0;
    for (const std::size_t i : {3U, 2U, 1U, 0U}) value = value << 8 | static_cast<unsigned char>(bytes_[from + i]);
    return value;
  }
  // Of the window whose lower end stands there: its upper end is 8 bytes on.
  [[nodiscard]] std::int64_t side(std::size_t low) const {
    return static_cast<std::int64_t>(static_cast<std::int32_t>(number(low + 8))) -
           static_cast<std::int32_t>(number(low)) + 1;
  }
  // Names, each with 16 bytes of form and sampling, and an empty name that ends the list just where the size says.
  void checkChannels(std::size_t from, std::size_t to) const {
    while (true) {
      const std::size_t end = bytes_.find('\0', from);
      if (end == std::string_view::npos || end >= to) damaged();
      if (end == from) break;
      from = end + 17;
    }
    if (from + 1 != to) damaged();
  }

  std::string_view bytes_;
  const std::string& path_;
  std::size_t at_ = 0;
};

}  // namespace

void checkSize(std::int64_t width, std::int64_t height, std::size_t bytes, const std::string& path) {
  if (width < 1 || height < 1 || width > largestSide || height > largestSide) {
    throw core::InputError({path, 0, 0}, "image-size",
                           fmt::format("an image of {} x {} pixels cannot be read", width, height));
  }
  // No method packs tighter than deflate's 1 : 1032; three channels have at least 2 bytes a pixel each.
  if (width * height * 6 > static_cast<std::int64_t>(bytes) * 1100) {
    throw core::InputError({path, 0, 0}, "damaged-image",
                           fmt::format("the header promises {} x {} pixels, which {} bytes cannot hold; the file is "
                                       "damaged",
                                       width, height, bytes));
  }
}

void checkExrHeader(std::string_view bytes, const std::string& path) {
  Walker(bytes, path).walk();
}

}  // namespace goniolux::image
