// Picture files: code values with the device's description.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "display/code_image.h"
#include "display/device.h"

namespace goniolux::display {

enum class PictureFormat { png, tiff, jpeg, dpx, exr };

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

/// EXR: not codes but the light that the device gives for 16-bit codes, as linear R, G, B of its primaries (of Rec. 709
/// for film and ICC profiles), with its luminance of white where that is known.
void writeExrPicture(const std::string& path, const CodeImage& image, const Device& device);

/// Encodes and writes; an earlier file stays whole until the new one is. core::RunError when it cannot be written.
void writePicture(const std::string& path, const CodeImage& image, const Device& device);

/// What a reader takes unless told otherwise: a few kilobytes of a compressed file can promise gigabytes.
inline constexpr double mostPixels = 1e8;

/// Code values of a PNG, TIFF, JPEG or DPX file of three channels (a fourth is left out, grey is copied);
/// core::InputError for others, damaged ones and those of more than `most` pixels, naming `path`.
CodeImage readPicture(const std::string& path, double most = mostPixels);
CodeImage decodePng(std::string_view bytes, const std::string& path, double most = mostPixels);
CodeImage decodeTiff(std::string_view bytes, const std::string& path, double most = mostPixels);
CodeImage decodeJpeg(std::string_view bytes, const std::string& path, double most = mostPixels);
CodeImage decodeDpx(std::string_view bytes, const std::string& path);

/// core::InputError for a picture of more than `most` pixels.
void checkPixels(double width, double height, double most, const std::string& path);

}  // namespace goniolux::display
