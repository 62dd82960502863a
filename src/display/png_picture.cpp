#include <png.h>

#include <csetjmp>
#include <cstddef>
#include <vector>

#include "core/diagnostics.h"
#include "display/icc_profile.h"
#include "display/picture_file.h"

namespace goniolux::display {
namespace {

// Fast compression: pictures of a calculation are noisy, so that thorough search gains a few per cent for several times
// the time.
constexpr int compressionLevel = 2;

void append(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

void flush(png_structp) {}

// The library's own handlers would print.
[[noreturn]] void onError(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}
void onWarning(png_structp, png_const_charp) {}

bool isSrgb(const Device& device) {
  static const Device srgb = readDevice("srgb");
  const auto same = [](const auto& a, const auto& b) { return a.x == b.x && a.y == b.y; };
  return same(device.red, srgb.red) && same(device.green, srgb.green) && same(device.blue, srgb.blue) &&
         same(device.white, srgb.white) && device.transfer == srgb.transfer;
}

// The library reports errors by longjmp: everything that needs a destructor is made by the caller, before. False on an
// error.
bool encode(png_structp png, png_infop info, const CodeImage& image, const std::string& profile,
            std::vector<png_byte>& row, std::string& bytes) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &bytes, append, flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), image.bits,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, compressionLevel);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  if (profile.empty()) {
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_RELATIVE);
  } else {
    png_set_iCCP(png, info, "device", PNG_COMPRESSION_TYPE_BASE, reinterpret_cast<png_const_bytep>(profile.data()),
                 static_cast<png_uint_32>(profile.size()));
  }
  png_write_info(png, info);
  const std::size_t values = 3 * static_cast<std::size_t>(image.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    const std::uint16_t* codes = image.rgb.data() + y * values;
    for (std::size_t i = 0; i < values; ++i) {
      if (image.bits == 8) {
        row[i] = static_cast<png_byte>(codes[i]);
      } else {  // PNG is big-endian
        row[2 * i] = static_cast<png_byte>(codes[i] >> 8);
        row[2 * i + 1] = static_cast<png_byte>(codes[i] & 0xFF);
      }
    }
    png_write_row(png, row.data());
  }
  png_write_end(png, info);
  return true;
}

}  // namespace

std::string encodePng(const CodeImage& image, const Device& device) {
  const std::string profile = isSrgb(device) ? "" : iccProfile(device);
  std::vector<png_byte> row(6 * static_cast<std::size_t>(image.width));
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, onError, onWarning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  const bool done = info != nullptr && encode(png, info, image, profile, row, bytes);
  png_destroy_write_struct(&png, &info);
  if (!done) throw core::RunError("the picture cannot be encoded as PNG");
  return bytes;
}

}  // namespace goniolux::display
