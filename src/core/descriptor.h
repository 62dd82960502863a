// Descriptor: an open file of the system, closed at the end of its scope, and the words for what the disk said. For the
// files of core/ that write on POSIX calls: only they tell why the disk said no and reach fsync.
#pragma once

#include <string>
#include <string_view>

namespace goniolux::core {

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    close();
    number_ = other.release();
    return *this;
  }
  [[nodiscard]] int get() const { return number_; }
  [[nodiscard]] bool ok() const { return number_ >= 0; }
  /// False when the system reports, only now, that data was lost.
  bool close();

 private:
  int release() {
    const int number = number_;
    number_ = -1;
    return number;
  }

  int number_;
};

/// What an errno means and what to do about it.
std::string diskReason(int error);

/// All the bytes at the file's present place; false with errno set when the disk says no.
bool writeAll(int descriptor, std::string_view bytes);

}  // namespace goniolux::core
