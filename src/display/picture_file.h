// Picture files: code values with the device's description, as PNG (8 or 16 bit) or TIFF (16 bit).
#pragma once

#include <string>

#include "display/device.h"
#include "display/mapping.h"

namespace goniolux::display {

enum class PictureFormat { png, tiff };

/// The format that a file's ending stands for; core::InputError for endings that are unknown or not supported yet.
PictureFormat pictureFormat(const std::string& path);

/// The file's bytes. PNG: sRGB chunk for a device with sRGB's primaries, white and curve, an ICC profile for any other.
/// TIFF: 16 bit, lossless deflate, ICC profile.
std::string encodePng(const CodeImage& image, const Device& device);
std::string encodeTiff(const CodeImage& image, const Device& device);

/// Encodes and writes; an earlier file stays whole until the new one is. core::RunError when it cannot be written.
void writePicture(const std::string& path, const CodeImage& image, const Device& device);

}  // namespace goniolux::display
