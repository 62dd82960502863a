#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <exception>
#include <list>

#include "core/diagnostics.h"
#include "core/document.h"
#include "image/exr.h"
#include "image/exr_names.h"
#include "image/exr_streams.h"
#include "spectrum/hats.h"

namespace goniolux::image {
namespace {

// What the numbers are: X and Z carry the same constant as Y, whose unit is cd/m2. White (1, 1, 1) then has
// `whiteLuminance` cd/m2.
void describe(Imf::Header& header, const XyzImage& image, float whiteLuminance) {
  Imf::addChromaticities(header, Imf::Chromaticities({1, 0}, {0, 1}, {0, 0}, {1.0F / 3, 1.0F / 3}));
  Imf::addWhiteLuminance(header, whiteLuminance);
  std::map<std::string, std::string> attributes{
      {unitsAttribute, "cd/m2"},
      {"observer", "CIE 1931 2 degree"},
      {"spectralRange_nm", fmt::format("{} {}", spectrum::visibleFrom, spectrum::visibleTo)}};
  if (!image.spectrum.empty()) {  // the layout's own attributes
    attributes["spectralLayoutVersion"] = "1.0";
    attributes["emissiveUnits"] = "W.m^-2.sr^-1.nm^-1";
  }
  for (const auto& [name, value] : image.attributes) attributes[name] = value;
  for (const auto& [name, value] : attributes) header.insert(name, Imf::StringAttribute(value));
}

// The smallest power of two, at least 1, that brings every value below the largest 16-bit float (65504).
float scaleFor16Bits(const XyzImage& image) {
  float largest = 0;
  for (const auto* values : {&image.x, &image.y, &image.z})
    for (const float value : *values)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  float scale = 1;
  while (largest / scale > 65000) scale *= 2;
  return scale;
}

class Writer {
 public:
  Writer(const XyzImage& image, ExrForm form) : image_(image), form_(form), header_(image.width, image.height) {
    header_.compression() = form == ExrForm::paper ? Imf::RLE_COMPRESSION : Imf::ZIP_COMPRESSION;
    if (form != ExrForm::float32) scale_ = scaleFor16Bits(image);
    describe(header_, image, scale_);
  }

  void add(const std::string& name, const std::vector<float>& values, float scale = 1) {
    if (values.empty()) return;
    const auto width = static_cast<std::size_t>(image_.width);
    const Imath::Box2i& window = header_.dataWindow();
    if (form_ == ExrForm::float32) {
      header_.channels().insert(name, Imf::Channel(Imf::FLOAT));
      // The library reads through a pointer that is not const, for output too.
      auto* data = const_cast<float*>(values.data());
      buffer_.insert(name, Imf::Slice::Make(Imf::FLOAT, data, window, sizeof(float), sizeof(float) * width));
      return;
    }
    std::vector<Imath::half>& converted = halves_.emplace_back();
    converted.reserve(values.size());
    for (const float value : values) converted.emplace_back(value / scale);
    header_.channels().insert(name, Imf::Channel(Imf::HALF));
    buffer_.insert(
        name, Imf::Slice::Make(Imf::HALF, converted.data(), window, sizeof(Imath::half), sizeof(Imath::half) * width));
  }

  std::string bytes() {
    add("X", image_.x, scale_);
    add("Y", image_.y, scale_);
    add("Z", image_.z, scale_);
    if (form_ != ExrForm::paper) {
      add(halfWidthChannel, image_.halfWidth, scale_);
      add(chromaticityXChannel, image_.chromaticityX);
      add(chromaticityYChannel, image_.chromaticityY);
      for (const SpectralChannel& channel : image_.spectrum) {
        add(spectralChannelName(channel.wavelength_nm), channel.values);
        add(spectralChannelName(channel.wavelength_nm) + halfWidthEnding, channel.halfWidth);
      }
      for (const Layer& layer : image_.layers) {
        add(layer.name + ".X", layer.x, scale_);
        add(layer.name + ".Y", layer.y, scale_);
        add(layer.name + ".Z", layer.z, scale_);
        add(layer.name + '.' + halfWidthChannel, layer.halfWidth, scale_);
      }
    }
    MemoryOutput stream;
    {
      Imf::OutputFile file(stream, header_);
      file.setFrameBuffer(buffer_);
      file.writePixels(image_.height);
    }
    return stream.bytes();
  }

 private:
  const XyzImage& image_;
  ExrForm form_;
  Imf::Header header_;
  Imf::FrameBuffer buffer_;
  std::list<std::vector<Imath::half>> halves_;  // what the frame buffer points into
  float scale_ = 1;
};

}  // namespace

std::string spectralChannelName(double wavelength_nm) {
  std::string number = fmt::format("{:.6f}", wavelength_nm);
  std::replace(number.begin(), number.end(), '.', ',');
  return "S0." + number + "nm";
}

void writeRgbExr(const std::string& path, const XyzImage& image, const RgbSpace& space, double white_cd_m2) {
  const glm::mat3 matrix(glm::inverse(xyzFromRgb(space)) / (white_cd_m2 > 0 ? white_cd_m2 : 1));
  std::vector<float> planes[3];
  for (auto& plane : planes) plane.resize(image.y.size());
  for (std::size_t i = 0; i < image.y.size(); ++i) {
    const glm::vec3 rgb = matrix * glm::vec3(image.x[i], image.y[i], image.z[i]);
    for (int c = 0; c < 3; ++c) planes[c][i] = rgb[c];
  }
  try {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    const auto point = [](const spectrum::Chromaticity& c) {
      return Imath::V2f(static_cast<float>(c.x), static_cast<float>(c.y));
    };
    Imf::addChromaticities(header, {point(space.red), point(space.green), point(space.blue), point(space.white)});
    if (white_cd_m2 > 0) Imf::addWhiteLuminance(header, static_cast<float>(white_cd_m2));
    for (const auto& [name, value] : image.attributes) header.insert(name, Imf::StringAttribute(value));
    Imf::FrameBuffer buffer;
    for (int c = 0; c < 3; ++c) {
      const char* name = c == 0 ? "R" : c == 1 ? "G" : "B";
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, planes[c].data(), header.dataWindow()));
    }
    MemoryOutput stream;
    {
      Imf::OutputFile file(stream, header);
      file.setFrameBuffer(buffer);
      file.writePixels(image.height);
    }
    core::writeFile(path, stream.bytes());
  } catch (const core::RunError&) {
    throw;
  } catch (const std::exception& error) {
    throw core::RunError(fmt::format("{}: the image cannot be encoded: {}", path, error.what()));
  }
}

void writeExr(const std::string& path, const XyzImage& image, ExrForm form) {
  [[maybe_unused]] const std::size_t count =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  assert(image.width > 0 && image.height > 0);
  assert(image.x.size() == count && image.y.size() == count && image.z.size() == count);
  assert(image.halfWidth.empty() || image.halfWidth.size() == count);
  std::string bytes;
  try {
    bytes = Writer(image, form).bytes();
  } catch (const std::exception& error) {
    throw core::RunError(fmt::format("{}: the image cannot be encoded: {}", path, error.what()));
  }
  core::writeFile(path, bytes);
}

}  // namespace goniolux::image
