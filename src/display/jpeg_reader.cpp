#include <csetjmp>
#include <cstddef>
#include <cstdio>  // jpeglib.h needs it
#include <vector>

#include <jpeglib.h>

#include "core/diagnostics.h"
#include "display/picture_file.h"

namespace goniolux::display {
namespace {

struct Errors {
  jpeg_error_mgr manager;
  std::jmp_buf home;
};

// The library's own handlers would print and end the process.
[[noreturn]] void onError(j_common_ptr info) {
  std::longjmp(reinterpret_cast<Errors*>(info->err)->home, 1);
}
void onOutput(j_common_ptr) {}

// The library reports errors by longjmp: everything that needs a destructor is made by the caller. False on an error.
bool decode(jpeg_decompress_struct& info, Errors& errors, std::string_view bytes, double most, CodeImage& image,
            std::vector<JSAMPLE>& row) {
  if (setjmp(errors.home) != 0) return false;
  jpeg_create_decompress(&info);
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&info, TRUE);
  image.width = static_cast<int>(info.image_width);
  image.height = static_cast<int>(info.image_height);
  // A block of 8 x 8 pixels takes two bits at least.
  const double pixels = static_cast<double>(info.image_width) * info.image_height;
  if (pixels > most || pixels > 1100.0 * 8 * static_cast<double>(bytes.size())) return false;
  if (info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK) return false;
  info.out_color_space = JCS_RGB;
  jpeg_start_decompress(&info);
  row.resize(3 * static_cast<std::size_t>(info.output_width));
  while (info.output_scanline < info.output_height) {
    JSAMPROW pointer = row.data();
    jpeg_read_scanlines(&info, &pointer, 1);
    image.rgb.insert(image.rgb.end(), row.begin(), row.end());
  }
  jpeg_finish_decompress(&info);
  // Where data end too early the library goes on with grey and a warning.
  return errors.manager.num_warnings == 0;
}

}  // namespace

CodeImage decodeJpeg(std::string_view bytes, const std::string& path, double most) {
  CodeImage image;
  std::vector<JSAMPLE> row;
  jpeg_decompress_struct info{};
  Errors errors{};
  info.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = onError;
  errors.manager.emit_message = [](j_common_ptr common, int level) {
    if (level < 0) ++common->err->num_warnings;
  };
  errors.manager.output_message = onOutput;
  const bool done = decode(info, errors, bytes, most, image, row);
  jpeg_destroy_decompress(&info);
  if (done) return image;
  checkPixels(image.width, image.height, most, path);
  throw core::InputError({path, 0, 0}, "damaged-picture",
                         "the JPEG picture is damaged or of another kind than RGB and grey; write it anew");
}

}  // namespace goniolux::display
