// Streams of the OpenEXR library that pass through memory, so that writing is atomic (core::writeFile) and a damaged
// file can be measured before the library believes its header.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace goniolux::image {

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

}  // namespace goniolux::image
