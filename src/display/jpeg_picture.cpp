#include <csetjmp>
#include <cstddef>
#include <cstdio>  // jpeglib.h needs it
#include <cstdlib>
#include <vector>

#include <jpeglib.h>

#include "core/diagnostics.h"
#include "display/icc_profile.h"
#include "display/picture_file.h"

namespace goniolux::display {
namespace {

constexpr int quality = 95;

struct Errors {
  jpeg_error_mgr manager;
  std::jmp_buf home;
};

// The library's own handlers would print and end the process.
[[noreturn]] void onError(j_common_ptr info) {
  std::longjmp(reinterpret_cast<Errors*>(info->err)->home, 1);
}
void onMessage(j_common_ptr, int) {}
void onOutput(j_common_ptr) {}

// The library reports errors by longjmp: everything that needs a destructor is made by the caller. False on an error.
bool encode(jpeg_compress_struct& info, Errors& errors, const CodeImage& image, const std::string& profile,
            std::vector<JSAMPLE>& row, unsigned char** bytes, unsigned long* size) {
  if (setjmp(errors.home) != 0) return false;
  jpeg_create_compress(&info);
  jpeg_mem_dest(&info, bytes, size);
  info.image_width = static_cast<JDIMENSION>(image.width);
  info.image_height = static_cast<JDIMENSION>(image.height);
  info.input_components = 3;
  info.in_color_space = JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, quality, TRUE);
  info.comp_info[0].h_samp_factor = info.comp_info[0].v_samp_factor = 1;  // colours at full resolution
  jpeg_start_compress(&info, TRUE);
  if (!profile.empty())
    jpeg_write_icc_profile(&info, reinterpret_cast<const JOCTET*>(profile.data()),
                           static_cast<unsigned>(profile.size()));
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = static_cast<JSAMPLE>(image.rgb[y * row.size() + i]);
    JSAMPROW pointer = row.data();
    jpeg_write_scanlines(&info, &pointer, 1);
  }
  jpeg_finish_compress(&info);
  return true;
}

}  // namespace

std::string encodeJpeg(const CodeImage& image, const Device& device) {
  if (image.width > 65500 || image.height > 65500)
    throw core::RunError("a JPEG picture has at most 65500 pixels a side; write a PNG");
  const std::string profile = iccProfile(device);
  std::vector<JSAMPLE> row(3 * static_cast<std::size_t>(image.width));
  jpeg_compress_struct info{};
  Errors errors{};
  info.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = onError;
  errors.manager.emit_message = onMessage;
  errors.manager.output_message = onOutput;
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const bool done = encode(info, errors, image, profile, row, &bytes, &size);
  std::string result(reinterpret_cast<const char*>(bytes), done ? size : 0);
  jpeg_destroy_compress(&info);
  std::free(bytes);
  if (!done) throw core::RunError("the picture cannot be encoded as JPEG");
  return result;
}

}  // namespace goniolux::display
