#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <utility>

#include "core/diagnostics.h"
#include "core/document.h"
#include "core/parallel.h"
#include "core/text.h"
#include "image/exr.h"
#include "image/exr_header_check.h"
#include "image/exr_names.h"
#include "image/exr_streams.h"
#include "image/rgb_to_xyz.h"

namespace goniolux::image {
namespace {

[[noreturn]] void refuse(const std::string& path, const char* rule, std::string message) {
  throw core::InputError({path, 0, 0}, rule, std::move(message));
}

// "S0.550,000000nm": the emissive, unpolarised part of the spectral layout.
std::optional<double> wavelengthOf(std::string_view channel) {
  if (!channel.starts_with("S0.") || !channel.ends_with("nm")) return std::nullopt;
  std::string number(channel.substr(3, channel.size() - 5));
  std::replace(number.begin(), number.end(), ',', '.');
  const auto value = core::parseNumber(number);
  return value && *value > 0 && *value < 1e5 ? value : std::nullopt;
}

// Layers whose X, Y and Z are all there.
std::vector<Layer> layersOf(const Imf::ChannelList& channels) {
  std::vector<Layer> layers;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    const std::string_view name = channel.name();
    if (!name.ends_with(".X") || name.size() <= 2) continue;
    const std::string layer(name.substr(0, name.size() - 2));
    if (channels.findChannel(layer + ".Y") != nullptr && channels.findChannel(layer + ".Z") != nullptr)
      layers.push_back({layer, {}, {}, {}, {}});
  }
  return layers;
}

// Whether the image is R, G, B; refuses what is neither that nor X, Y, Z.
bool isRgb(const Imf::ChannelList& channels, const std::string& path) {
  std::string found;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    found += (found.empty() ? "" : ", ") + std::string(channel.name());
    if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) {
      refuse(path, "subsampled-image", fmt::format("channel {} is subsampled; store every pixel", channel.name()));
    }
  }
  const bool rgb = channels.findChannel("R") != nullptr && channels.findChannel("X") == nullptr;
  for (const char* needed : {rgb ? "R" : "X", rgb ? "G" : "Y", rgb ? "B" : "Z"}) {
    if (channels.findChannel(needed) != nullptr) continue;
    refuse(path, "missing-channel",
           fmt::format("channel {} is missing (found: {}); an image of CIE X, Y, Z in cd/m2 is needed, as 'goniolux "
                       "render' writes it, or one of R, G, B",
                       needed, found));
  }
  return rgb;
}

// The calibration of the numbers: a factor for X, Y, Z; R, G, B are turned into X, Y, Z.
void calibrate(XyzImage& image, const Imf::Header& header, bool rgb) {
  const bool hasWhite = Imf::hasWhiteLuminance(header);
  float white = hasWhite ? Imf::whiteLuminance(header) : 1;
  if (!(white > 0) || !std::isfinite(white)) white = 1;
  if (!hasWhite && !image.attributes.contains(unitsAttribute)) image.attributes[unitsAttribute] = "relative";
  if (rgb) {
    RgbSpace space;
    if (Imf::hasChromaticities(header)) {
      const Imf::Chromaticities& c = Imf::chromaticities(header);
      const auto point = [](const Imath::V2f& v) {
        return spectrum::Chromaticity{static_cast<double>(v.x), static_cast<double>(v.y)};
      };
      space = {point(c.red), point(c.green), point(c.blue), point(c.white)};
    }
    toXyz(image, space, static_cast<double>(white));
    return;
  }
  if (white == 1) return;
  for (auto* values : {&image.x, &image.y, &image.z, &image.halfWidth})
    for (float& value : *values) value *= white;
  for (Layer& layer : image.layers)
    for (auto* values : {&layer.x, &layer.y, &layer.z, &layer.halfWidth})
      for (float& value : *values) value *= white;
}

XyzImage decode(std::string_view bytes, const std::string& path) {
  checkExrHeader(bytes, path);
  Imf::Header::setMaxImageSize(largestSide, largestSide);  // the library's, for all files: before any thread reads
  MemoryInput stream(bytes);
  Imf::InputFile file(stream);
  const Imf::Header& header = file.header();
  const bool rgb = isRgb(header.channels(), path);
  const Imath::Box2i window = header.dataWindow();
  const auto width = static_cast<std::int64_t>(window.max.x) - window.min.x + 1;
  const auto height = static_cast<std::int64_t>(window.max.y) - window.min.y + 1;
  checkSize(width, height, bytes.size(), path);

  XyzImage image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  const auto count = static_cast<std::size_t>(width * height);
  const Imf::ChannelList& channels = header.channels();
  for (auto channel = channels.begin(); channel != channels.end(); ++channel)
    if (const auto wavelength = wavelengthOf(channel.name())) image.spectrum.push_back({*wavelength, {}, {}});
  std::sort(image.spectrum.begin(), image.spectrum.end(),
            [](const auto& a, const auto& b) { return a.wavelength_nm < b.wavelength_nm; });
  Imf::FrameBuffer buffer;
  const auto add = [&](const std::string& name, std::vector<float>& values) {
    if (channels.findChannel(name) == nullptr) return;
    values.resize(count);
    buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), window, sizeof(float),
                                         sizeof(float) * static_cast<std::size_t>(image.width)));
  };
  add(rgb ? "R" : "X", image.x);
  add(rgb ? "G" : "Y", image.y);
  add(rgb ? "B" : "Z", image.z);
  add(halfWidthChannel, image.halfWidth);
  add(chromaticityXChannel, image.chromaticityX);
  add(chromaticityYChannel, image.chromaticityY);
  for (SpectralChannel& each : image.spectrum) {
    add(spectralChannelName(each.wavelength_nm), each.values);
    add(spectralChannelName(each.wavelength_nm) + halfWidthEnding, each.halfWidth);
  }
  image.layers = layersOf(channels);
  for (Layer& layer : image.layers) {
    add(layer.name + ".X", layer.x);
    add(layer.name + ".Y", layer.y);
    add(layer.name + ".Z", layer.z);
    add(layer.name + '.' + halfWidthChannel, layer.halfWidth);
  }
  // Other programs may write a wavelength with fewer digits: a channel that is not found under our name is left out.
  std::erase_if(image.spectrum, [](const SpectralChannel& each) { return each.values.empty(); });
  // Bands of lines are unpacked on all threads, each by a reader of its own; no packing method joins more lines than a
  // band has.
  constexpr int bandLines = 256;
  const auto bands = static_cast<std::size_t>((height + bandLines - 1) / bandLines);
  core::parallelFor(bands, 1, [&](std::size_t first, std::size_t last) {
    MemoryInput bandStream(bytes);
    Imf::InputFile band(bandStream);
    band.setFrameBuffer(buffer);
    band.readPixels(window.min.y + static_cast<int>(first) * bandLines,
                    std::min(window.max.y, window.min.y + static_cast<int>(last) * bandLines - 1));
  });
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
    if (text != nullptr) image.attributes[attribute.name()] = text->value();
  }
  calibrate(image, header, rgb);
  return image;
}

}  // namespace

XyzImage decodeExr(std::string_view bytes, const std::string& path) {
  constexpr std::string_view magic("\x76\x2f\x31\x01", 4);
  if (bytes.substr(0, 4) != magic) {
    refuse(path, "not-an-exr", "this is not an OpenEXR image; give an image that 'goniolux render' wrote");
  }
  try {
    return decode(bytes, path);
  } catch (const core::InputError&) {
    throw;
  } catch (const std::exception& error) {
    refuse(path, "damaged-image",
           fmt::format("the image cannot be read, the file is damaged: {}; render it again", error.what()));
  }
}

XyzImage readExr(const std::string& path) {
  return decodeExr(core::readFile(path), path);
}

}  // namespace goniolux::image
