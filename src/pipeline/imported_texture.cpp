#include "pipeline/imported_texture.h"

#include <algorithm>
#include <cmath>

#include "display/picture_file.h"

namespace goniolux::pipeline {
namespace {

using core::Value;
using core::Vec3;
using display::PictureFormat;

const Vec3 luminousShare(0.2126, 0.7152, 0.0722);  // of the linear values of sRGB: IEC 61966-2-1
constexpr double mostTexturePixels = 4e7;          // as the project reader allows

double decoded(double code) {  // IEC 61966-2-1
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

display::CodeImage read(const geometry::MeshPicture& picture, const std::string& bytes) {
  switch (display::pictureFormat("picture" + picture.extension)) {
    case PictureFormat::png:
      return display::decodePng(bytes, picture.file, mostTexturePixels);
    case PictureFormat::tiff:
      return display::decodeTiff(bytes, picture.file, mostTexturePixels);
    case PictureFormat::jpeg:
      return display::decodeJpeg(bytes, picture.file, mostTexturePixels);
    case PictureFormat::dpx:
    case PictureFormat::exr:
      break;
  }
  throw core::InputError({picture.file, 0, 0}, "picture-format", "is no texture picture; save it as PNG or JPEG");
}

double luminousMean(const display::CodeImage& image) {
  std::vector<double> linear(static_cast<std::size_t>(1) << image.bits);
  for (std::size_t code = 0; code < linear.size(); ++code)
    linear[code] = decoded(static_cast<double>(code) / static_cast<double>(linear.size() - 1));
  Vec3 sum(0);
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
    sum += Vec3(linear[image.rgb[i]], linear[image.rgb[i + 1]], linear[image.rgb[i + 2]]);
  return 3 * glm::dot(sum, luminousShare) / static_cast<double>(std::max<std::size_t>(image.rgb.size(), 1));
}

}  // namespace

ImportedTexture importedTexture(const geometry::MeshPicture& picture, const std::string& file) {
  ImportedTexture made;
  made.bytes = picture.bytes.empty() ? core::readFile(picture.file) : picture.bytes;
  const double mean = luminousMean(read(picture, made.bytes)), level = glm::dot(picture.factor, luminousShare);
  if (!(mean * level > 0))
    throw core::InputError({picture.file, 0, 0}, "picture-black", "is black; it has no colours to take");
  made.texture = Value::Object{{"image", file}, {"mapping", "uv"}};
  // Values are reflectances; where the model darkens all of them, they are scaled to the mean that it means.
  if (std::abs(level - 1) < 1e-6) made.texture.set("calibrated", true);
  made.reflectance = std::clamp(std::round(mean * level * 1e4) / 1e4, 1e-4, 1.0);
  const Vec3 tint = glm::abs(picture.factor - Vec3(level));
  if (std::max({tint.x, tint.y, tint.z}) > 0.01) made.left = "; the tint that the model lays over it is left out";
  if (picture.isMoved) made.left += "; that the model moves, turns or repeats it is left out";
  return made;
}

}  // namespace goniolux::pipeline
