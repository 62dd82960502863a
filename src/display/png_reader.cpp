#include <png.h>

#include <csetjmp>
#include <cstring>
#include <vector>

#include "core/diagnostics.h"
#include "display/picture_file.h"

namespace goniolux::display {
namespace {

constexpr png_uint_32 largestSide = 65536;

struct Source {
  std::string_view bytes;
  double mostPixels = 0;
  std::size_t position = 0;
};

void read(png_structp png, png_bytep into, std::size_t count) {
  auto& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (count > source.bytes.size() - source.position) png_error(png, "the file ends too early");
  std::memcpy(into, source.bytes.data() + source.position, count);
  source.position += count;
}

[[noreturn]] void onError(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}
void onWarning(png_structp, png_const_charp) {}

// The library reports errors by longjmp: everything that needs a destructor is made by the caller. False on an error.
bool decode(png_structp png, png_infop info, Source& source, CodeImage& image, std::vector<png_byte>& row) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_read_fn(png, &source, read);
  png_set_user_limits(png, largestSide, largestSide);
  png_read_info(png, info);
  const png_uint_32 width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  // Deflate packs at most 1 : 1032.
  if (static_cast<double>(width) * height > 1100.0 * 8 * static_cast<double>(source.bytes.size())) return false;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  if (static_cast<double>(width) * height > source.mostPixels) return false;
  if (png_get_interlace_type(png, info) != PNG_INTERLACE_NONE) return false;
  png_set_expand(png);
  png_set_gray_to_rgb(png);
  png_set_strip_alpha(png);
  png_read_update_info(png, info);
  image.bits = png_get_bit_depth(png, info);
  const std::size_t values = 3 * static_cast<std::size_t>(width);
  if (png_get_rowbytes(png, info) != values * (image.bits == 16 ? 2 : 1)) return false;
  row.resize(png_get_rowbytes(png, info));
  for (png_uint_32 y = 0; y < height; ++y) {
    png_read_row(png, row.data(), nullptr);
    for (std::size_t i = 0; i < values; ++i)
      image.rgb.push_back(static_cast<std::uint16_t>(image.bits == 16 ? row[2 * i] << 8 | row[2 * i + 1] : row[i]));
  }
  return true;
}

}  // namespace

CodeImage decodePng(std::string_view bytes, const std::string& path, double most) {
  Source source{bytes, most};
  CodeImage image;
  std::vector<png_byte> row;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, onError, onWarning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  const bool done = info != nullptr && decode(png, info, source, image, row);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!done) {
    checkPixels(image.width, image.height, most, path);
    throw core::InputError({path, 0, 0}, "damaged-picture", "the PNG picture is damaged or interlaced; write it anew");
  }
  return image;
}

}  // namespace goniolux::display
