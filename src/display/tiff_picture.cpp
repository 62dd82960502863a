#include <tiffio.h>

#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "core/diagnostics.h"
#include "display/icc_profile.h"
#include "display/picture_file.h"
#include "display/tiff_memory.h"

namespace goniolux::display {
std::string encodeTiff(const CodeImage& image, const Device& device) {
  const std::string profile = iccProfile(device);
  TiffMemory memory;
  auto tiff = openTiff(memory, "w");
  if (!tiff) throw core::RunError("the picture cannot be encoded as TIFF");
  const auto width = static_cast<std::uint32_t>(image.width), height = static_cast<std::uint32_t>(image.height);
  TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, width);
  TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, height);
  TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, 16);
  TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, 3);
  TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
  TIFFSetField(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff.get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  TIFFSetField(tiff.get(), TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  TIFFSetField(tiff.get(), TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
  TIFFSetField(tiff.get(), TIFFTAG_ZIPQUALITY, 2);
  if (!profile.empty())
    TIFFSetField(tiff.get(), TIFFTAG_ICCPROFILE, static_cast<std::uint32_t>(profile.size()), profile.data());
  TIFFSetField(tiff.get(), TIFFTAG_SOFTWARE, "Goniolux");
  TIFFSetField(tiff.get(), TIFFTAG_ROWSPERSTRIP, 16U);
  const std::size_t values = 3 * static_cast<std::size_t>(image.width);
  std::vector<std::uint16_t> row(values);  // the library's predictor works in place
  for (std::uint32_t y = 0; y < height; ++y) {
    std::memcpy(row.data(), image.rgb.data() + y * values, values * sizeof(std::uint16_t));
    if (TIFFWriteScanline(tiff.get(), row.data(), y, 0) != 1)
      throw core::RunError("the picture cannot be encoded as TIFF");
  }
  tiff.reset();  // writes the directory
  return std::move(memory.bytes);
}

}  // namespace goniolux::display
