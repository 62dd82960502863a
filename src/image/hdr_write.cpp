#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "image/hdr.h"
#include "image/hdr_primaries.h"
#include "image/rgb_to_xyz.h"

namespace goniolux::image {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

// Mantissas are cut, not rounded: readers add half a step.
Pixel packed(const core::Vec3& colour) {
  const double largest = std::max({colour.x, colour.y, colour.z});
  if (!(largest > 1e-32) || !std::isfinite(largest)) return {0, 0, 0, 0};
  int exponent = 0;
  const double factor = std::frexp(largest, &exponent) * 256 / largest;
  if (exponent > 127) return {255, 255, 255, 255};
  Pixel pixel{};
  for (int i = 0; i < 3; ++i)
    pixel[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::clamp(std::isfinite(colour[i]) ? colour[i] * factor : 0.0, 0.0, 255.0));
  pixel[3] = static_cast<std::uint8_t>(exponent + 128);
  return pixel;
}

// One component of a row: runs of at least four equal bytes as 128 + n and the byte, others as n and n bytes.
void encodeComponent(const std::vector<Pixel>& row, std::size_t component, std::string& out) {
  std::size_t at = 0;
  const auto value = [&](std::size_t i) { return row[i][component]; };
  const auto runAt = [&](std::size_t i) {
    std::size_t n = 1;
    while (i + n < row.size() && n < 127 && value(i + n) == value(i)) ++n;
    return n;
  };
  while (at < row.size()) {
    std::size_t next = at, run = runAt(at);
    while (run < 4 && next < row.size()) {
      next += run;
      run = next < row.size() ? runAt(next) : 0;
    }
    while (at < next) {
      const std::size_t n = std::min<std::size_t>(128, next - at);
      out += static_cast<char>(n);
      for (std::size_t i = 0; i < n; ++i) out += static_cast<char>(value(at + i));
      at += n;
    }
    if (at < row.size()) {
      out += static_cast<char>(128 + run);
      out += static_cast<char>(value(at));
      at += run;
    }
  }
}

void encodeRow(const std::vector<Pixel>& row, std::string& out) {
  if (row.size() < 8 || row.size() > 32767) {  // the run-length form cannot say such widths
    for (const Pixel& pixel : row)
      for (const std::uint8_t byte : pixel) out += static_cast<char>(byte);
    return;
  }
  out += {2, 2, static_cast<char>(row.size() >> 8), static_cast<char>(row.size() & 0xFF)};
  for (std::size_t component = 0; component < 4; ++component) encodeComponent(row, component, out);
}

std::string oneLine(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32) c = ' ';
  return text;
}

}  // namespace

std::string encodeHdr(const XyzImage& image, HdrForm form) {
  std::string out = "#?RADIANCE\n";
  for (const auto& [name, value] : image.attributes)
    if (name != viewAttribute && name != unitsAttribute) out += fmt::format("# {}={}\n", name, oneLine(value));
  if (const auto view = image.attributes.find(viewAttribute); view != image.attributes.end())
    out += "VIEW= " + oneLine(view->second) + "\n";
  out += fmt::format("EXPOSURE=1\nFORMAT=32-bit_rle_{}\n\n-Y {} +X {}\n", form == HdrForm::xyze ? "xyze" : "rgbe",
                     image.height, image.width);
  const core::Mat3 matrix =
      form == HdrForm::xyze ? core::Mat3(1) : glm::inverse(xyzFromRgb(radiancePrimaries)) / radianceEfficacy_lm_W;
  const auto width = static_cast<std::size_t>(image.width);
  std::vector<Pixel> row(width);
  for (std::size_t begin = 0; begin < image.y.size(); begin += width) {
    for (std::size_t i = 0; i < width; ++i) {
      const std::size_t at = begin + i;
      row[i] = packed(matrix * core::Vec3(image.x[at], image.y[at], image.z[at]));
    }
    encodeRow(row, out);
  }
  return out;
}

}  // namespace goniolux::image
