#include <fmt/format.h>

#include <utility>

#include "core/diagnostics.h"
#include "display/picture_file.h"
#include "display/tiff_memory.h"

namespace goniolux::display {

CodeImage decodeTiff(std::string_view bytes, const std::string& path, double most) {
  const auto refuse = [&](std::string message) {
    throw core::InputError({path, 0, 0}, "damaged-picture", std::move(message));
  };
  TiffMemory memory{std::string(bytes), 0};
  const auto tiff = openTiff(memory, "r");
  if (!tiff) refuse("the TIFF picture cannot be read, it is damaged; write it anew");
  std::uint32_t width = 0, height = 0;
  std::uint16_t bits = 0, samples = 0, planes = PLANARCONFIG_CONTIG, kind = 0;
  TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_PLANARCONFIG, &planes);
  TIFFGetField(tiff.get(), TIFFTAG_PHOTOMETRIC, &kind);
  if ((bits != 8 && bits != 16) || (samples != 3 && samples != 4) || planes != PLANARCONFIG_CONTIG ||
      kind != PHOTOMETRIC_RGB || TIFFIsTiled(tiff.get()) != 0)
    refuse("only RGB pictures of 8 or 16 bits in strips can be read");
  if (width < 1 || height < 1 || width > 65536 || height > 65536 ||
      static_cast<double>(width) * height * 3 > 1100.0 * static_cast<double>(bytes.size()))
    refuse(fmt::format("the file promises {} x {} pixels, which {} bytes cannot hold; it is damaged", width, height,
                       bytes.size()));
  checkPixels(width, height, most, path);
  const std::size_t rowBytes = static_cast<std::size_t>(width) * samples * (bits / 8U);
  if (static_cast<std::size_t>(TIFFScanlineSize(tiff.get())) != rowBytes)
    refuse("the TIFF picture is damaged; write it anew");
  CodeImage image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.bits = bits;
  std::vector<std::uint16_t> row(rowBytes / 2 + 1);  // aligned for 16 bits
  const auto* byte = reinterpret_cast<const unsigned char*>(row.data());
  for (std::uint32_t y = 0; y < height; ++y) {
    if (TIFFReadScanline(tiff.get(), row.data(), y, 0) != 1) refuse("the TIFF picture is damaged; write it anew");
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        image.rgb.push_back(bits == 16 ? row[x * samples + c] : byte[x * samples + c]);
  }
  return image;
}

}  // namespace goniolux::display
