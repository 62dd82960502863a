// KeptWork: what a run has finished so far, on disk, so that an interrupted run goes on where it was ("checkpoint").
//
// Work is cut into items whose result is a pure function of their number (work_items.h), so a run is taken up by going
// through it once more with the results of finished items read instead of calculated: every decision falls as it did,
// to the last digit and for any number of threads. The file FOLDER/finished.work is a log: one record per slice of work
// of a few seconds, each with a check over itself and the record before it. It is made by writing beside and renaming,
// grows at its end, and reaches the disk (fsync) at most `interval` seconds after the work was done; of a torn or
// damaged end, the whole records before it are used. Runs shorter than the interval write nothing.
//
// The first record is the run's identity: what its results depend on, as a text that the caller makes and compares.
// Not thread-safe: called between pieces of work, from the thread that runs the stage.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/descriptor.h"

namespace goniolux::core {

/// Appends a plain value's bytes.
template <class T>
void put(std::string& bytes, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}
/// Takes a plain value off the front; false when there are too few bytes.
template <class T>
bool take(std::string_view& bytes, T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (bytes.size() < sizeof(T)) return false;
  std::memcpy(&value, bytes.data(), sizeof(T));
  bytes.remove_prefix(sizeof(T));
  return true;
}

/// What work cost; kept with it, so that a resumed run states what the whole took.
struct Spent {
  double wall_s = 0, cpu_s = 0;
  std::uint64_t rays = 0;
};

class KeptWork {
 public:
  static constexpr double usualInterval = 15;  ///< s

  /// Nothing is read or written yet. `folder` is made when the first record is written.
  KeptWork(std::string folder, std::string identity, double interval_s = usualInterval);
  ~KeptWork();
  KeptWork(const KeptWork&) = delete;
  KeptWork& operator=(const KeptWork&) = delete;

  /// Finds what an earlier run left; returns that run's identity, or nothing when there is none. The records are used
  /// from then on, and new ones follow them: ask only if it is the same run. Throws InputError when the file is damaged
  /// from its beginning, RunError while another run is at work on it.
  std::optional<std::string> findEarlier();
  /// Uses nothing of what was found.
  void forgetEarlier();
  /// Bytes at the file's end that were not whole and are not used.
  [[nodiscard]] std::size_t tornBytes() const { return torn_; }

  /// Hands over every record of a part of the work, in the order in which they were made.
  void recover(const std::string& part, const std::function<void(std::string_view)>& use);
  /// Adds a record; it goes to disk with the next commit.
  void add(const std::string& part, std::string_view record);
  /// The number that this part was decided to be when it was done first: `proposal`, the first time. For decisions that
  /// the clock has a say in.
  std::uint64_t decided(const std::string& part, std::uint64_t proposal);

  /// Writes what is new if it is time to. RunError when the disk says no; what was on it before stays whole.
  void commitWhenDue();
  void commit();
  /// The run is finished: removes the file, and the folder if it holds nothing else.
  void remove();
  [[nodiscard]] const std::string& file() const { return file_; }

  /// What the work that was recovered had cost.
  [[nodiscard]] const Spent& recovered() const { return recovered_; }
  void addRecovered(const Spent& spent);
  /// The ray counter of what is at work; 0 without one.
  void countRaysBy(std::function<std::uint64_t()> counter) { rays_ = std::move(counter); }
  [[nodiscard]] std::uint64_t rays() const { return rays_ ? rays_() : 0; }

 private:
  struct Place {
    std::uint64_t offset = 0, bytes = 0;  // of a record's content
  };
  [[nodiscard]] std::string recordOf(const std::string& part, std::string_view content);
  void begin();
  void append();
  [[noreturn]] void cannotWrite(int error) const;

  std::string folder_, file_, identity_;
  double interval_;
  std::function<std::uint64_t()> rays_;
  Descriptor log_;
  std::map<std::string, std::vector<Place>> known_;  // by part
  std::uint64_t whole_ = 0;                          // bytes of the file that are whole records
  std::size_t torn_ = 0;
  std::string lastCheck_;  // of the last record, written or not
  std::string pending_;
  double lastCommit_;
  Spent recovered_;
};

/// A place in a run's work: where its parts are kept, under which name. Without a log nothing is kept.
struct Keeping {
  KeptWork* log = nullptr;
  std::string name = {};

  [[nodiscard]] Keeping part(const std::string& of) const { return {log, log == nullptr ? name : name + "/" + of}; }
  [[nodiscard]] std::uint64_t decided(const std::string& what, std::uint64_t proposal) const {
    return log == nullptr ? proposal : log->decided(name + "/" + what, proposal);
  }
};

}  // namespace goniolux::core
