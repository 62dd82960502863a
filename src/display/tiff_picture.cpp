#include <tiffio.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "core/diagnostics.h"
#include "display/icc_profile.h"
#include "display/picture_file.h"

namespace goniolux::display {
namespace {

// A file in memory, as libtiff wants it: it goes back to fill in directories.
struct Memory {
  std::string bytes;
  std::size_t position = 0;
};

tsize_t writeTo(thandle_t handle, tdata_t data, tsize_t count) {
  auto& memory = *static_cast<Memory*>(handle);
  const auto size = static_cast<std::size_t>(count);
  if (memory.position + size > memory.bytes.size()) memory.bytes.resize(memory.position + size);
  std::memcpy(memory.bytes.data() + memory.position, data, size);
  memory.position += size;
  return count;
}

tsize_t readFrom(thandle_t handle, tdata_t data, tsize_t count) {
  auto& memory = *static_cast<Memory*>(handle);
  const std::size_t left = memory.bytes.size() - std::min(memory.position, memory.bytes.size());
  const std::size_t size = std::min(static_cast<std::size_t>(count), left);
  std::memcpy(data, memory.bytes.data() + memory.position, size);
  memory.position += size;
  return static_cast<tsize_t>(size);
}

toff_t seek(thandle_t handle, toff_t offset, int whence) {
  auto& memory = *static_cast<Memory*>(handle);
  const std::size_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? memory.position : memory.bytes.size();
  memory.position = base + static_cast<std::size_t>(offset);
  return memory.position;
}

int close(thandle_t) {
  return 0;
}
toff_t size(thandle_t handle) {
  return static_cast<Memory*>(handle)->bytes.size();
}

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

}  // namespace

std::string encodeTiff(const CodeImage& image, const Device& device) {
  const std::string profile = iccProfile(device);
  TIFFSetErrorHandler(nullptr);  // the library would print
  TIFFSetWarningHandler(nullptr);
  Memory memory;
  std::unique_ptr<TIFF, CloseTiff> tiff(
      TIFFClientOpen("memory", "w", &memory, readFrom, writeTo, seek, close, size, nullptr, nullptr));
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
