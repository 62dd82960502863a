// DPX, SMPTE ST 268:2003, version 2.0: 10 bit, three values filled to 32-bit words (method A), most significant byte
// first. The header says what the codes mean: for film their density (transfer "printing density", reference codes 0
// and 1023 with their densities), for monitors the transfer curve where the standard has a number for it.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/diagnostics.h"
#include "display/film.h"
#include "display/picture_file.h"

namespace goniolux::display {
namespace {

constexpr std::size_t headerSize = 2048;
// Offsets of the fields that are used.
constexpr std::size_t dataOffset = 4, version = 8, fileSize = 16, dittoKey = 20, genericSize = 24, industrySize = 28,
                      userSize = 32, creator = 160, project = 260, copyright = 460, encryption = 660, orientation = 768,
                      elements = 770, pixelsPerLine = 772, lines = 776, sign = 780, lowCode = 784, lowQuantity = 788,
                      highCode = 792, highQuantity = 796, descriptor = 800, transfer = 801, colorimetric = 802,
                      bitSize = 803, packing = 804, encoding = 806, elementOffset = 808, linePadding = 812,
                      imagePadding = 816, description = 820, pixelAspect = 1628;
constexpr unsigned rgb = 50, userDefined = 0, printingDensity = 1, bt709 = 6;

class Header {
 public:
  // Fields that are not known have all bits set; texts are empty.
  Header() : bytes_(headerSize, '\xff') {
    for (const auto& [from, size] : {std::pair<std::size_t, std::size_t>{36, 624},
                                     {664, 104},
                                     {1356, 52},
                                     {1432, 100},
                                     {1532, 24},
                                     {1556, 64},
                                     {1636, 28},
                                     {1664, 16},
                                     {1680, 32},
                                     {1732, 188}})
      std::fill_n(bytes_.begin() + static_cast<std::ptrdiff_t>(from), size, '\0');
  }
  void set8(std::size_t at, unsigned value) { bytes_[at] = static_cast<char>(value); }
  void set16(std::size_t at, unsigned value) {
    set8(at, value >> 8 & 0xFF);
    set8(at + 1, value & 0xFF);
  }
  void set32(std::size_t at, std::uint32_t value) {
    set16(at, value >> 16);
    set16(at + 2, value & 0xFFFF);
  }
  void setReal(std::size_t at, float value) { set32(at, std::bit_cast<std::uint32_t>(value)); }
  void setText(std::size_t at, std::size_t size, std::string_view text) {
    std::fill_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at), size, '\0');
    text = text.substr(0, size - 1);
    std::copy(text.begin(), text.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(at));
  }
  [[nodiscard]] std::string bytes() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(path) {
    swapped_ = bytes.starts_with("XPDS");
  }
  CodeImage read() const {
    if (bytes_.size() < headerSize) refuse("the DPX header is not complete; the file is damaged");
    CodeImage image;
    const std::uint32_t width = get32(pixelsPerLine), height = get32(lines), offset = get32(dataOffset);
    const bool plain = get8(descriptor) == rgb && get8(bitSize) == 10 && get16(packing) == 1 && get16(encoding) == 0;
    if (!plain) refuse("only DPX pictures of R, G, B with 10 bits, filled to 32-bit words, can be read");
    const double needed = 4.0 * static_cast<double>(width) * static_cast<double>(height);
    if (width < 1 || height < 1 || offset < 1664 ||
        static_cast<double>(offset) + needed > static_cast<double>(bytes_.size()))
      refuse(fmt::format("the header promises {} x {} pixels, which {} bytes cannot hold; the file is damaged", width,
                         height, bytes_.size()));
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.bits = 10;
    image.rgb.reserve(3 * static_cast<std::size_t>(width) * height);
    for (std::size_t i = 0; i < static_cast<std::size_t>(width) * height; ++i) {
      const std::uint32_t word = get32(offset + 4 * i);
      for (const int shift : {22, 12, 2}) image.rgb.push_back(static_cast<std::uint16_t>(word >> shift & 0x3FF));
    }
    return image;
  }

 private:
  [[noreturn]] void refuse(std::string message) const {
    throw core::InputError({path_, 0, 0}, "damaged-picture", std::move(message));
  }
  [[nodiscard]] std::uint32_t get8(std::size_t at) const { return static_cast<unsigned char>(bytes_[at]); }
  [[nodiscard]] std::uint32_t get16(std::size_t at) const {
    return swapped_ ? get8(at + 1) << 8 | get8(at) : get8(at) << 8 | get8(at + 1);
  }
  [[nodiscard]] std::uint32_t get32(std::size_t at) const {
    return swapped_ ? get16(at + 2) << 16 | get16(at) : get16(at) << 16 | get16(at + 2);
  }

  std::string_view bytes_;
  const std::string& path_;
  bool swapped_ = false;
};

void describeCodes(Header& header, const Device& device) {
  header.set32(lowCode, 0);
  header.set32(highCode, 1023);
  if (device.kind == Device::Kind::film) {
    const Film& film = *device.film;
    // Densities count from code 0; the film's base stands at its code.
    header.setReal(lowQuantity, 0);
    header.setReal(highQuantity, static_cast<float>(1023 * film.densityPerCode));
    header.set8(transfer, printingDensity);
    header.set8(colorimetric, printingDensity);
    header.setText(description, 32,
                   fmt::format("{} density, {:g} D/code", film.reversal ? "dye" : "printing", film.densityPerCode));
    return;
  }
  header.setReal(lowQuantity, 0);
  header.setReal(highQuantity, 1);
  const bool video = device.name == "Rec. 709";
  header.set8(transfer, video ? bt709 : userDefined);
  header.set8(colorimetric, video ? bt709 : userDefined);
  header.setText(description, 32, device.name);
}

}  // namespace

std::string encodeDpx(const CodeImage& image, const Device& device) {
  const std::size_t pixels = image.rgb.size() / 3;
  if (headerSize + 4 * pixels > std::numeric_limits<std::uint32_t>::max())
    throw core::RunError("the picture is too large for a DPX file (4 GB)");
  Header header;
  header.setText(0, 5, "SDPX");
  header.set32(dataOffset, headerSize);
  header.setText(version, 8, "V2.0");
  header.set32(fileSize, static_cast<std::uint32_t>(headerSize + 4 * pixels));
  header.set32(dittoKey, 1);
  header.set32(genericSize, 1664);
  header.set32(industrySize, 384);
  header.set32(userSize, 0);
  header.setText(creator, 100, "Goniolux");
  header.setText(project, 200, device.name);
  header.setText(copyright, 200, "");
  header.set32(encryption, 0xFFFFFFFF);  // none
  header.set16(orientation, 0);          // from the left, from the top
  header.set16(elements, 1);
  header.set32(pixelsPerLine, static_cast<std::uint32_t>(image.width));
  header.set32(lines, static_cast<std::uint32_t>(image.height));
  header.set32(sign, 0);
  header.set8(descriptor, rgb);
  header.set8(bitSize, 10);
  header.set16(packing, 1);
  header.set16(encoding, 0);
  header.set32(elementOffset, headerSize);
  header.set32(linePadding, 0);
  header.set32(imagePadding, 0);
  header.set32(pixelAspect, 1);
  header.set32(pixelAspect + 4, 1);
  describeCodes(header, device);
  std::string bytes = std::move(header).bytes();
  bytes.reserve(headerSize + 4 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint32_t word = static_cast<std::uint32_t>(image.rgb[3 * i]) << 22 |
                               static_cast<std::uint32_t>(image.rgb[3 * i + 1]) << 12 |
                               static_cast<std::uint32_t>(image.rgb[3 * i + 2]) << 2;
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(word >> shift & 0xFF);
  }
  return bytes;
}

CodeImage decodeDpx(std::string_view bytes, const std::string& path) {
  return Reader(bytes, path).read();
}

}  // namespace goniolux::display
