#include "display/picture_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/diagnostics.h"
#include "core/document.h"

namespace goniolux::display {

PictureFormat pictureFormat(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".png") return PictureFormat::png;
  if (ending == ".tif" || ending == ".tiff") return PictureFormat::tiff;
  const bool later = ending == ".dpx" || ending == ".jpg" || ending == ".jpeg";
  throw core::InputError({path, 0, 0}, "picture-format",
                         later
                             ? fmt::format("not supported yet: {} pictures; name the output .png or .tif", ending)
                             : fmt::format("'{}' stands for no picture format; name the output .png or .tif", ending));
}

void writePicture(const std::string& path, const CodeImage& image, const Device& device) {
  const PictureFormat format = pictureFormat(path);
  core::writeFile(path, format == PictureFormat::png ? encodePng(image, device) : encodeTiff(image, device));
}

}  // namespace goniolux::display
