#include "core/kept_work.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include "core/diagnostics.h"
#include "core/parallel.h"
#include "core/sha256.h"

namespace goniolux::core {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t checkBytes = 16;            // of the hexadecimal digest
constexpr std::size_t mostPending = 256U << 20U;  // bytes kept in memory before they are written early
constexpr std::uint32_t mark = 0x31574c47;        // "GLW1"
const std::string noRecord(checkBytes, '0');      // stands before the first one
constexpr const char* identityPart = "identity";  // the first record

struct Head {
  std::uint32_t mark = core::mark;
  std::uint32_t nameBytes = 0;
  std::uint64_t contentBytes = 0;
};

bool readAll(int file, std::uint64_t offset, char* to, std::size_t bytes) {
  while (bytes > 0) {
    const ssize_t count = ::pread(file, to, bytes, static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    to += count;
    offset += static_cast<std::uint64_t>(count);
    bytes -= static_cast<std::size_t>(count);
  }
  return true;
}

std::string checkOf(std::string_view previousAndRecord) {
  return sha256(previousAndRecord).substr(0, checkBytes);
}

}  // namespace

KeptWork::KeptWork(std::string folder, std::string identity, double interval_s)
    : folder_(std::move(folder)),
      file_((fs::path(folder_) / "finished.work").string()),
      identity_(std::move(identity)),
      interval_(interval_s),
      lastCheck_(noRecord),
      lastCommit_(wallSeconds()) {}

KeptWork::~KeptWork() = default;

// A record: its check, then what the check is over beside the check of the record before: head, name, content.
std::string KeptWork::recordOf(const std::string& part, std::string_view content) {
  std::string record = lastCheck_;
  put(record, Head{mark, static_cast<std::uint32_t>(part.size()), content.size()});
  record += part;
  record += content;
  lastCheck_ = checkOf(record);
  record.replace(0, checkBytes, lastCheck_);
  return record;
}

std::optional<std::string> KeptWork::findEarlier() {
  log_ = Descriptor(::open(file_.c_str(), O_RDWR | O_CLOEXEC));
  if (!log_.ok()) {
    if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
    throw InputError({file_, 0, 0}, "unreadable-checkpoint",
                     fmt::format("this checkpoint cannot be read: {}", diskReason(errno)));
  }
  if (::flock(log_.get(), LOCK_EX | LOCK_NB) != 0)
    throw RunError(fmt::format("{}: another run is at work on it; wait for its end or stop it", file_));
  struct stat status {};
  const std::uint64_t size =
      ::fstat(log_.get(), &status) == 0 && S_ISREG(status.st_mode) ? static_cast<std::uint64_t>(status.st_size) : 0;

  std::optional<std::string> identity;
  std::string check = noRecord, record;
  std::uint64_t at = 0;
  while (size - at >= checkBytes + sizeof(Head)) {
    Head head;
    record.resize(checkBytes + sizeof(Head));
    if (!readAll(log_.get(), at, record.data(), record.size())) break;
    std::string_view rest = std::string_view(record).substr(checkBytes);
    take(rest, head);
    const std::uint64_t room = size - at - record.size();
    if (head.mark != mark || head.nameBytes > room || head.contentBytes > room - head.nameBytes) break;
    const std::string stated = record.substr(0, checkBytes);
    const std::size_t before = record.size();
    record.resize(before + head.nameBytes + head.contentBytes);
    if (!readAll(log_.get(), at + before, record.data() + before, record.size() - before)) break;
    record.replace(0, checkBytes, check);
    if (checkOf(record) != stated) break;
    check = stated;
    const std::string name = record.substr(before, head.nameBytes);
    if (at == 0) {
      if (name != identityPart) break;
      identity = record.substr(before + head.nameBytes);
    } else {
      known_[name].push_back({at + before + head.nameBytes, head.contentBytes});
    }
    at += record.size();
  }
  if (!identity) {
    log_.close();
    throw InputError({file_, 0, 0}, "damaged-checkpoint",
                     "this checkpoint is damaged from its beginning and of no use; run without --resume, which begins "
                     "anew and replaces it");
  }
  whole_ = at;
  torn_ = static_cast<std::size_t>(size - at);
  lastCheck_ = check;
  return identity;
}

void KeptWork::forgetEarlier() {
  log_.close();
  known_.clear();
  whole_ = 0;
  torn_ = 0;
  lastCheck_ = noRecord;
}

void KeptWork::recover(const std::string& part, const std::function<void(std::string_view)>& use) {
  const auto found = known_.find(part);
  if (found == known_.end()) return;
  std::string content;
  for (const Place& place : found->second) {
    content.resize(place.bytes);
    if (!readAll(log_.get(), place.offset, content.data(), content.size()))
      throw RunError(fmt::format("{}: cannot be read: {}", file_, diskReason(errno)));
    use(content);
  }
  known_.erase(found);  // what is finished is asked for once
}

void KeptWork::add(const std::string& part, std::string_view record) {
  if (pending_.empty() && !log_.ok()) pending_ = recordOf(identityPart, identity_);
  pending_ += recordOf(part, record);
}

std::uint64_t KeptWork::decided(const std::string& part, std::uint64_t proposal) {
  std::optional<std::uint64_t> earlier;
  recover(part, [&](std::string_view content) {
    std::uint64_t value = 0;
    if (take(content, value)) earlier = value;
  });
  if (earlier) return *earlier;
  std::string record;
  put(record, proposal);
  add(part, record);
  return proposal;
}

void KeptWork::commitWhenDue() {
  if (wallSeconds() - lastCommit_ >= interval_ || pending_.size() > mostPending) commit();
}

void KeptWork::commit() {
  if (!pending_.empty()) {
    if (log_.ok())
      append();
    else
      begin();
    whole_ += pending_.size();
    torn_ = 0;
    std::string().swap(pending_);
  }
  lastCommit_ = wallSeconds();
}

// A new file is whole under its name or not there: an earlier run's checkpoint stays until then.
void KeptWork::begin() {
  std::error_code failure;
  fs::create_directories(folder_, failure);
  if (failure) cannotWrite(failure.value());
  const std::string temporary = file_ + ".part";
  Descriptor log(::open(temporary.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!log.ok()) cannotWrite(errno);
  if (!writeAll(log.get(), pending_) || ::fsync(log.get()) != 0 || ::rename(temporary.c_str(), file_.c_str()) != 0) {
    const int error = errno;
    ::unlink(temporary.c_str());
    cannotWrite(error);
  }
  ::flock(log.get(), LOCK_EX | LOCK_NB);  // for who resumes while this run is still at work
  const Descriptor folder(::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.ok()) ::fsync(folder.get());  // so that the name, too, is there after a power cut
  log_ = std::move(log);
}

void KeptWork::append() {
  if (torn_ > 0 && ::ftruncate(log_.get(), static_cast<off_t>(whole_)) != 0) cannotWrite(errno);
  if (::lseek(log_.get(), static_cast<off_t>(whole_), SEEK_SET) < 0 || !writeAll(log_.get(), pending_) ||
      ::fdatasync(log_.get()) != 0) {
    const int error = errno;
    if (::ftruncate(log_.get(), static_cast<off_t>(whole_)) != 0) torn_ = 1;  // the next reader passes over it
    cannotWrite(error);
  }
}

void KeptWork::cannotWrite(int error) const {
  throw RunError(
      fmt::format("{}: the checkpoint cannot be written: {}; what is on the disk is kept, --resume goes on from it",
                  file_, diskReason(error)));
}

void KeptWork::remove() {
  pending_.clear();
  log_.close();
  std::error_code ignored;
  fs::remove(file_, ignored);
  fs::remove(file_ + ".part", ignored);
  fs::remove(folder_, ignored);  // only when it is empty
}

void KeptWork::addRecovered(const Spent& spent) {
  recovered_.wall_s += spent.wall_s;
  recovered_.cpu_s += spent.cpu_s;
  recovered_.rays += spent.rays;
}

}  // namespace goniolux::core
