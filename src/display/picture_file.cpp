#include "display/picture_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/diagnostics.h"
#include "core/document.h"
#include "core/text.h"

namespace goniolux::display {

PictureFormat pictureFormat(const std::string& path) {
  const std::string ending = core::lowerCase(std::filesystem::path(path).extension().string());
  if (ending == ".png") return PictureFormat::png;
  if (ending == ".tif" || ending == ".tiff") return PictureFormat::tiff;
  if (ending == ".jpg" || ending == ".jpeg") return PictureFormat::jpeg;
  if (ending == ".dpx") return PictureFormat::dpx;
  if (ending == ".exr") return PictureFormat::exr;
  throw core::InputError(
      {path, 0, 0}, "picture-format",
      fmt::format("'{}' stands for no picture format; name the output .png, .tif, .jpg, .dpx or .exr", ending));
}

std::vector<int> bitsOf(PictureFormat format) {
  switch (format) {
    case PictureFormat::png:
      return {8, 16};
    case PictureFormat::tiff:
    case PictureFormat::exr:
      return {16};
    case PictureFormat::dpx:
      return {10};
    default:
      return {8};
  }
}

void writePicture(const std::string& path, const CodeImage& image, const Device& device) {
  switch (pictureFormat(path)) {
    case PictureFormat::png:
      return core::writeFile(path, encodePng(image, device));
    case PictureFormat::tiff:
      return core::writeFile(path, encodeTiff(image, device));
    case PictureFormat::jpeg:
      return core::writeFile(path, encodeJpeg(image, device));
    case PictureFormat::dpx:
      return core::writeFile(path, encodeDpx(image, device));
    case PictureFormat::exr:
      return writeExrPicture(path, image, device);
  }
}

void checkPixels(double width, double height, double most, const std::string& path) {
  if (width * height <= most) return;
  throw core::InputError(
      {path, 0, 0}, "too-large",
      fmt::format("the picture has {:.0f} x {:.0f} pixels, more than the {:.0f} million that are read "
                  "here; make it smaller",
                  width, height, most / 1e6));
}

CodeImage readPicture(const std::string& path, double most) {
  const std::string bytes = core::readFile(path);
  const std::string_view start = std::string_view(bytes).substr(0, 4);
  if (start == "\x89PNG") return decodePng(bytes, path, most);
  if (start == "SDPX" || start == "XPDS") return decodeDpx(bytes, path);
  if (start.starts_with("II") || start.starts_with("MM")) return decodeTiff(bytes, path, most);
  if (start.starts_with("\xFF\xD8")) return decodeJpeg(bytes, path, most);
  throw core::InputError({path, 0, 0}, "picture-format",
                         "this is no picture of code values that can be read; give a PNG, TIFF, JPEG or DPX file");
}

}  // namespace goniolux::display
