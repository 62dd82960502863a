// Picture files: code values with the device's description.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "display/code_image.h"
#include "display/device.h"

namespace goniolux::display {

enum class PictureFormat { png, tiff, jpeg, dpx };

/// The format that a file's ending stands for; core::InputError for endings that are unknown.
PictureFormat pictureFormat(const std::string& path);
/// Bits per channel that the format can hold, the usual one first.
std::vector<int> bitsOf(PictureFormat format);

/// The file's bytes. PNG: sRGB chunk for a device with sRGB's primaries, white and curve, cICP for BT.2100 PQ, an ICC
/// profile for any other. TIFF: 16 bit, lossless deflate, ICC profile. JPEG: quality 95, full colour resolution, ICC
/// profile. DPX (SMPTE ST 268): 10 bit, header of dpx.h.
std::string encodePng(const CodeImage& image, const Device& device);
std::string encodeTiff(const CodeImage& image, const Device& device);
std::string encodeJpeg(const CodeImage& image, const Device& device);
std::string encodeDpx(const CodeImage& image, const Device& device);

/// Encodes and writes; an earlier file stays whole until the new one is. core::RunError when it cannot be written.
void writePicture(const std::string& path, const CodeImage& image, const Device& device);

/// Code values of a PNG, TIFF or DPX file of three channels (a fourth is left out, grey is copied); core::InputError
/// for others and damaged ones, naming `path`.
CodeImage readPicture(const std::string& path);
CodeImage decodePng(std::string_view bytes, const std::string& path);
CodeImage decodeTiff(std::string_view bytes, const std::string& path);
CodeImage decodeDpx(std::string_view bytes, const std::string& path);

}  // namespace goniolux::display
