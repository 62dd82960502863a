#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/diagnostics.h"
#include "core/text.h"
#include "image/hdr.h"
#include "image/hdr_primaries.h"
#include "image/rgb_to_xyz.h"

namespace goniolux::image {
namespace {

using Pixel = std::array<std::uint8_t, 4>;
constexpr double largestSide = 65536;

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  XyzImage read() {
    readHeader();
    readResolution();
    // A run packs at most 127 pixels of a component into 2 bytes; the old form 255 pixels and more into 4.
    if (static_cast<double>(image_.width) * image_.height > 300.0 * static_cast<double>(bytes_.size())) {
      refuse(fmt::format("the header promises {} x {} pixels, which {} bytes cannot hold; the file is damaged",
                         image_.width, image_.height, bytes_.size()));
    }
    const auto width = static_cast<std::size_t>(image_.width), height = static_cast<std::size_t>(image_.height);
    for (auto* plane : {&image_.x, &image_.y, &image_.z}) plane->reserve(width * height);
    std::vector<Pixel> row(width);
    for (std::size_t y = 0; y < height; ++y) {
      readRow(row);
      for (const Pixel& pixel : row) append(pixel);
    }
    if (!xyz_) toXyz(image_, primaries_, radianceEfficacy_lm_W);
    image_.attributes[unitsAttribute] = "cd/m2";
    return std::move(image_);
  }

 private:
  [[noreturn]] void refuse(std::string message) const {
    throw core::InputError({path_, line_, 0}, "damaged-image", std::move(message));
  }

  std::string_view line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos || end - at_ > 4096) refuse("the header of the picture does not end");
    std::string_view text = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    ++line_;
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
  }

  std::vector<double> numbers(std::string_view text, std::size_t count, const char* what) const {
    core::TextScanner scanner(text);
    std::vector<double> values;
    while (const auto word = scanner.word("")) {
      const auto value = core::parseNumber(word->text);
      if (!value || !std::isfinite(*value)) refuse(fmt::format("{} has to be followed by {} numbers", what, count));
      values.push_back(*value);
    }
    if (values.size() != count) refuse(fmt::format("{} has to be followed by {} numbers", what, count));
    return values;
  }

  void readHeader() {
    bool hasFormat = false;
    line();  // "#?RADIANCE", looked at by the caller
    for (std::string_view text = line(); !text.empty(); text = line()) {
      const std::size_t sign = text.find('=');
      const std::string_view key = text.substr(0, sign);
      const std::string_view value = sign == std::string_view::npos ? "" : core::trimmed(text.substr(sign + 1));
      if (key == "FORMAT") {
        hasFormat = value == "32-bit_rle_rgbe" || value == "32-bit_rle_xyze";
        xyz_ = value == "32-bit_rle_xyze";
        if (!hasFormat) refuse(fmt::format("the pixel format '{}' is not known; 32-bit_rle_rgbe and _xyze are", value));
      } else if (key == "EXPOSURE") {
        divideBy(core::Vec3(numbers(value, 1, "EXPOSURE")[0]));
      } else if (key == "COLORCORR") {
        const auto c = numbers(value, 3, "COLORCORR");
        divideBy({c[0], c[1], c[2]});
      } else if (key == "PRIMARIES") {
        const auto p = numbers(value, 8, "PRIMARIES");
        primaries_ = {{p[0], p[1]}, {p[2], p[3]}, {p[4], p[5]}, {p[6], p[7]}};
      } else if (key == "VIEW") {
        image_.attributes[viewAttribute] = std::string(value);
      } else if (key.starts_with("# ") && sign != std::string_view::npos) {  // as encodeHdr writes attributes
        image_.attributes[std::string(key.substr(2))] = std::string(value);
      }
    }
    if (!hasFormat) refuse("the header has no line FORMAT=; is this a Radiance picture?");
  }

  void divideBy(const core::Vec3& factors) {
    if (!(factors.x > 0 && factors.y > 0 && factors.z > 0)) refuse("EXPOSURE and COLORCORR must be above 0");
    scale_ /= factors;
  }

  void readResolution() {
    core::TextScanner scanner(line());
    std::array<std::string_view, 4> words;
    for (auto& word : words) {
      const auto next = scanner.word("");
      if (!next) refuse("the line '-Y height +X width' is missing");
      word = next->text;
    }
    if (words[0] != "-Y" || words[2] != "+X") {
      refuse(fmt::format("rows must run from the top and from the left (-Y +X), not {} {}; turn it with 'pflip'",
                         words[0], words[2]));
    }
    const auto height = core::parseNumber(words[1]), width = core::parseNumber(words[3]);
    const auto fits = [](const std::optional<double>& side) {
      return side && *side >= 1 && *side <= largestSide && *side == std::floor(*side);
    };
    if (!fits(height) || !fits(width)) refuse(fmt::format("an image of {} x {} cannot be read", words[3], words[1]));
    image_.width = static_cast<int>(*width);
    image_.height = static_cast<int>(*height);
  }

  std::uint8_t byte() {
    if (at_ >= bytes_.size()) refuse("the picture ends too early; the file is damaged");
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }

  void readRow(std::vector<Pixel>& row) {
    Pixel first{};
    for (auto& component : first) component = byte();
    if (first[0] != 2 || first[1] != 2 || first[2] > 127) {
      readOldRow(row, first);
      return;
    }
    if ((static_cast<std::size_t>(first[2]) << 8 | first[3]) != row.size())
      refuse("a row has another width than the picture; the file is damaged");
    for (std::size_t component = 0; component < 4; ++component) {
      for (std::size_t i = 0; i < row.size();) {
        const std::uint8_t code = byte();
        const std::size_t count = code > 128 ? code - 128U : code;
        if (count == 0 || count > row.size() - i) refuse("a run is longer than its row; the file is damaged");
        const std::uint8_t same = code > 128 ? byte() : std::uint8_t{0};
        for (std::size_t n = 0; n < count; ++n) row[i++][component] = code > 128 ? same : byte();
      }
    }
  }

  // Pixels one by one; (1, 1, 1, n) repeats the last one n times, further ones count in the next byte of the number.
  void readOldRow(std::vector<Pixel>& row, Pixel pixel) {
    int shift = 0;
    for (std::size_t i = 0;;) {
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
        const std::size_t count = static_cast<std::size_t>(pixel[3]) << shift;
        if (i == 0 || count > row.size() - i) refuse("a run is longer than its row; the file is damaged");
        for (std::size_t n = 0; n < count; ++n, ++i) row[i] = row[i - 1];
        shift = std::min(shift + 8, 24);
      } else {
        row[i++] = pixel;
        shift = 0;
      }
      if (i == row.size()) return;
      for (auto& component : pixel) component = byte();
    }
  }

  void append(const Pixel& pixel) {
    const double factor = pixel[3] == 0 ? 0 : std::ldexp(1.0, pixel[3] - (128 + 8));
    const auto value = [&](std::size_t i, double scale) {
      return static_cast<float>(pixel[3] == 0 ? 0 : (pixel[i] + 0.5) * factor * scale);
    };
    image_.x.push_back(value(0, scale_.x));
    image_.y.push_back(value(1, scale_.y));
    image_.z.push_back(value(2, scale_.z));
  }

  std::string_view bytes_;
  const std::string& path_;
  std::size_t at_ = 0;
  int line_ = 0;
  bool xyz_ = false;
  core::Vec3 scale_{1};
  RgbSpace primaries_ = radiancePrimaries;
  XyzImage image_;
};

}  // namespace

XyzImage decodeHdr(std::string_view bytes, const std::string& path) {
  return Reader(bytes, path).read();
}

}  // namespace goniolux::image
