#include "display/tiff_memory.h"

#include <algorithm>
#include <cstring>

namespace goniolux::display {
namespace {

tsize_t writeTo(thandle_t handle, tdata_t data, tsize_t count) {
  auto& memory = *static_cast<TiffMemory*>(handle);
  const auto size = static_cast<std::size_t>(count);
  if (memory.position + size > memory.bytes.size()) memory.bytes.resize(memory.position + size);
  std::memcpy(memory.bytes.data() + memory.position, data, size);
  memory.position += size;
  return count;
}

tsize_t readFrom(thandle_t handle, tdata_t data, tsize_t count) {
  auto& memory = *static_cast<TiffMemory*>(handle);
  const std::size_t left = memory.bytes.size() - std::min(memory.position, memory.bytes.size());
  const std::size_t size = std::min(static_cast<std::size_t>(count), left);
  std::memcpy(data, memory.bytes.data() + std::min(memory.position, memory.bytes.size()), size);
  memory.position += size;
  return static_cast<tsize_t>(size);
}

toff_t seek(thandle_t handle, toff_t offset, int whence) {
  auto& memory = *static_cast<TiffMemory*>(handle);
  const std::size_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? memory.position : memory.bytes.size();
  memory.position = base + static_cast<std::size_t>(offset);
  return memory.position;
}

int close(thandle_t) {
  return 0;
}

toff_t size(thandle_t handle) {
  return static_cast<TiffMemory*>(handle)->bytes.size();
}

}  // namespace

std::unique_ptr<TIFF, CloseTiff> openTiff(TiffMemory& memory, const char* mode) {
  TIFFSetErrorHandler(nullptr);
  TIFFSetWarningHandler(nullptr);
  // No memory mapping: TIFFClientOpen without the two functions reads through readFrom.
  return std::unique_ptr<TIFF, CloseTiff>(
      TIFFClientOpen("memory", mode, &memory, readFrom, writeTo, seek, close, size, nullptr, nullptr));
}

}  // namespace goniolux::display
