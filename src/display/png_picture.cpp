#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstddef>

#include "core/diagnostics.h"
#include "display/icc_profile.h"
#include "display/picture_file.h"
#include "display/png_rows.h"

namespace goniolux::display {
namespace {

void append(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

void flush(png_structp) {}

// The library's own handlers would print.
[[noreturn]] void onError(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}
void onWarning(png_structp, png_const_charp) {}

bool samePrimaries(const Device& a, const Device& b) {
  const auto same = [](const auto& p, const auto& q) { return p.x == q.x && p.y == q.y; };
  return same(a.red, b.red) && same(a.green, b.green) && same(a.blue, b.blue) && same(a.white, b.white);
}

// How the file says what its codes mean.
struct ColourSpace {
  bool isSrgb = false, isPq = false;
  std::string profile;
};
ColourSpace colourSpaceOf(const Device& device) {
  static const Device srgb = readDevice("srgb"), pq = readDevice("rec2020-pq");
  ColourSpace space;
  if (device.kind == Device::Kind::monitor) {
    space.isSrgb = samePrimaries(device, srgb) && device.transfer == srgb.transfer;
    space.isPq = samePrimaries(device, pq) && device.transfer[0].form == TransferCurve::Form::pq;
  }
  if (!space.isSrgb && !space.isPq) space.profile = iccProfile(device);
  return space;
}

// The library reports errors by longjmp: everything that needs a destructor is made by the caller, before. False on an
// error.
bool encode(png_structp png, png_infop info, const CodeImage& image, const ColourSpace& space, const std::string& rows,
            std::string& bytes) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &bytes, append, flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), image.bits,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (space.isSrgb) png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_RELATIVE);
  if (!space.profile.empty())
    png_set_iCCP(png, info, "device", PNG_COMPRESSION_TYPE_BASE,
                 reinterpret_cast<png_const_bytep>(space.profile.data()),
                 static_cast<png_uint_32>(space.profile.size()));
  png_write_info(png, info);
  if (space.isPq) {  // PNG, third edition: primaries of BT.2020, curve of ST 2084, no matrix, full range (ITU-T H.273)
    constexpr png_byte name[5] = {'c', 'I', 'C', 'P', 0}, content[4] = {9, 16, 0, 1};
    png_write_chunk(png, name, content, sizeof(content));
  }
  constexpr png_byte data[5] = {'I', 'D', 'A', 'T', 0}, end[5] = {'I', 'E', 'N', 'D', 0};
  constexpr std::size_t chunk = 1 << 20;
  for (std::size_t at = 0; at < rows.size(); at += chunk)
    png_write_chunk(png, data, reinterpret_cast<png_const_bytep>(rows.data()) + at, std::min(chunk, rows.size() - at));
  png_write_chunk(png, end, nullptr, 0);
  return true;
}

}  // namespace

std::string encodePng(const CodeImage& image, const Device& device) {
  const ColourSpace space = colourSpaceOf(device);
  const std::string rows = compressedRows(image);
  std::string bytes;
  bytes.reserve(rows.size() + 4096);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, onError, onWarning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  const bool done = info != nullptr && encode(png, info, image, space, rows, bytes);
  png_destroy_write_struct(&png, &info);
  if (!done) throw core::RunError("the picture cannot be encoded as PNG");
  return bytes;
}

}  // namespace goniolux::display
