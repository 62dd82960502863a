// OpenEXR files of XyzImage: the only source file that uses the OpenEXR library. Files pass through memory, so that
// writing is atomic (core::writeFile) and a damaged file can be measured before the library believes its header.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <string_view>
#include <utility>

#include "core/diagnostics.h"
#include "core/document.h"
#include "core/parallel.h"
#include "image/xyz_image.h"
#include "spectrum/hats.h"

namespace goniolux::image {
namespace {

constexpr const char* halfWidthChannel = "Y.halfWidth";
constexpr int largestSide = 65536;  // pixels; bounds what a damaged header can make the library allocate

class MemoryOutput final : public Imf::OStream {
 public:
  MemoryOutput() : Imf::OStream("memory") {}
  void write(const char bytes[], int count) override {
    const std::size_t end = position_ + static_cast<std::size_t>(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + position_, bytes, static_cast<std::size_t>(count));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

class MemoryInput final : public Imf::IStream {
 public:
  explicit MemoryInput(std::string_view bytes) : Imf::IStream("memory"), bytes_(bytes) {}
  bool read(char into[], int count) override {
    const auto wanted = static_cast<std::size_t>(count);
    if (count < 0 || position_ > bytes_.size() || wanted > bytes_.size() - position_) {
      throw std::runtime_error("the file ends too early");
    }
    std::memcpy(into, bytes_.data() + position_, wanted);
    position_ += wanted;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }
  void clear() override {}

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
};

// What the numbers are: X and Z carry the same constant as Y, whose unit is cd/m2. White (1, 1, 1) then has 1 cd/m2.
void describe(Imf::Header& header, const XyzImage& image) {
  Imf::addChromaticities(header, Imf::Chromaticities({1, 0}, {0, 1}, {0, 0}, {1.0F / 3, 1.0F / 3}));
  Imf::addWhiteLuminance(header, 1);
  std::map<std::string, std::string> attributes{
      {"photometricUnits", "cd/m2"},
      {"observer", "CIE 1931 2 degree"},
      {"spectralRange_nm", fmt::format("{} {}", spectrum::visibleFrom, spectrum::visibleTo)}};
  for (const auto& [name, value] : image.attributes) attributes[name] = value;
  for (const auto& [name, value] : attributes) header.insert(name, Imf::StringAttribute(value));
}

Imf::Slice sliceOf(std::vector<float>& values, int width, const Imath::Box2i& window) {
  return Imf::Slice::Make(Imf::FLOAT, values.data(), window, sizeof(float),
                          sizeof(float) * static_cast<std::size_t>(width));
}

[[noreturn]] void refuse(const std::string& path, const char* rule, std::string message) {
  throw core::InputError({path, 0, 0}, rule, std::move(message));
}

void checkChannels(const Imf::ChannelList& channels, const std::string& path) {
  std::string found;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    found += (found.empty() ? "" : ", ") + std::string(channel.name());
    if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) {
      refuse(path, "subsampled-image", fmt::format("channel {} is subsampled; store every pixel", channel.name()));
    }
  }
  for (const char* needed : {"X", "Y", "Z"}) {
    if (channels.findChannel(needed) == nullptr) {
      refuse(path, "missing-channel",
             fmt::format("channel {} is missing (found: {}); an image of CIE X, Y, Z in cd/m2 is needed, as 'goniolux "
                         "render' writes it",
                         needed, found));
    }
  }
}

XyzImage decode(std::string_view bytes, const std::string& path) {
  Imf::Header::setMaxImageSize(largestSide, largestSide);  // the library's, for all files: before any thread reads
  MemoryInput stream(bytes);
  Imf::InputFile file(stream);
  const Imf::Header& header = file.header();
  checkChannels(header.channels(), path);
  const Imath::Box2i window = header.dataWindow();
  const auto width = static_cast<std::int64_t>(window.max.x) - window.min.x + 1;
  const auto height = static_cast<std::int64_t>(window.max.y) - window.min.y + 1;
  if (width < 1 || height < 1 || width > largestSide || height > largestSide) {
    refuse(path, "image-size", fmt::format("an image of {} x {} pixels cannot be read", width, height));
  }
  // No method packs tighter than deflate's 1 : 1032; three channels have at least 2 bytes a pixel each.
  if (width * height * 6 > static_cast<std::int64_t>(bytes.size()) * 1100) {
    refuse(path, "damaged-image",
           fmt::format("the header promises {} x {} pixels, which {} bytes cannot hold; the file is damaged", width,
                       height, bytes.size()));
  }

  XyzImage image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  const auto count = static_cast<std::size_t>(width * height);
  Imf::FrameBuffer buffer;
  const auto add = [&](const char* name, std::vector<float>& values) {
    values.resize(count);
    buffer.insert(name, sliceOf(values, image.width, window));
  };
  add("X", image.x);
  add("Y", image.y);
  add("Z", image.z);
  if (header.channels().findChannel(halfWidthChannel) != nullptr) add(halfWidthChannel, image.halfWidth);
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
  return image;
}

}  // namespace

void writeExr(const std::string& path, const XyzImage& image) {
  [[maybe_unused]] const std::size_t count =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  assert(image.width > 0 && image.height > 0);
  assert(image.x.size() == count && image.y.size() == count && image.z.size() == count);
  assert(image.halfWidth.empty() || image.halfWidth.size() == count);
  MemoryOutput stream;
  try {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    describe(header, image);
    Imf::FrameBuffer buffer;
    const auto add = [&](const char* name, const std::vector<float>& values) {
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      // The library reads through a pointer that is not const, for output too.
      buffer.insert(name, sliceOf(const_cast<std::vector<float>&>(values), image.width, header.dataWindow()));
    };
    add("X", image.x);
    add("Y", image.y);
    add("Z", image.z);
    if (!image.halfWidth.empty()) add(halfWidthChannel, image.halfWidth);
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(buffer);
    file.writePixels(image.height);
  } catch (const std::exception& error) {
    throw core::RunError(fmt::format("{}: the image cannot be encoded: {}", path, error.what()));
  }
  core::writeFile(path, stream.bytes());
}

XyzImage readExr(const std::string& path) {
  const std::string bytes = core::readFile(path);
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

}  // namespace goniolux::image
