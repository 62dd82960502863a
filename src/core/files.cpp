// readFile and writeFile of document.h, on POSIX calls: only they tell why the disk said no and reach fsync.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/descriptor.h"
#include "core/document.h"

namespace goniolux::core {
namespace {

[[noreturn]] void cannotRead(const std::string& path, const std::string& why) {
  throw InputError({path, 0, 0}, "unreadable-file", fmt::format("this file cannot be read: {}", why));
}

[[noreturn]] void cannotWrite(const std::string& path, int error) {
  throw RunError(fmt::format("{}: cannot be written: {}", path, diskReason(error)));
}

}  // namespace

bool Descriptor::close() {
  const int number = release();
  return number < 0 || ::close(number) == 0;
}

std::string diskReason(int error) {
  std::string text = std::strerror(error);
  if (error == ENOSPC || error == EDQUOT) text += "; free some space and run again";
  if (error == EACCES || error == EPERM || error == EROFS) text += "; check the folder's permissions";
  if (error == ENOENT) text += "; does the folder exist?";
  return text;
}

bool writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string readFile(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.ok()) cannotRead(path, std::strerror(errno));
  struct stat status {};
  const bool known = ::fstat(file.get(), &status) == 0;
  if (known && S_ISDIR(status.st_mode)) cannotRead(path, "it is a folder");
  std::string bytes;
  if (known && S_ISREG(status.st_mode)) bytes.reserve(static_cast<std::size_t>(status.st_size));  // images are large
  std::array<char, 65536> buffer{};
  for (;;) {
    const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) cannotRead(path, std::strerror(errno));
    if (count == 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

void writeFile(const std::string& path, std::string_view bytes, Durability durability) {
  static std::atomic<unsigned> serial{0};  // two writers in one process never share a temporary name
  const std::string temporary = fmt::format("{}.{}-{}.part", path, ::getpid(), serial++);
  Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!file.ok()) cannotWrite(path, errno);
  // The bytes must be on the disk before the name is: after a power cut there is the old file or the new one, whole.
  // Waiting for the disk takes longer than calculating a small room, so files that repeat others do without.
  if (!writeAll(file.get(), bytes) || (durability == Durability::toTheDisk && ::fsync(file.get()) != 0) ||
      !file.close() || ::rename(temporary.c_str(), path.c_str()) != 0) {
    const int error = errno;
    file.close();
    ::unlink(temporary.c_str());
    cannotWrite(path, error);
  }
}

}  // namespace goniolux::core
