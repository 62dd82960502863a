#include "pipeline/run_log.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <filesystem>

#include "core/descriptor.h"
#include "core/parallel.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr double firstWrite = 5, progressInterval = 1;  // s

/// A document on one line: its line ends stand between its parts only, those within texts are escaped.
std::string onOneLine(const core::Value& value) {
  std::string line;
  bool indented = false;
  for (const char c : core::toJson(value)) {
    if (c == '\n' || (indented && c == ' ')) {
      indented = true;
      continue;
    }
    if (indented && !line.empty() && line.back() == ',') line += ' ';
    indented = false;
    line += c;
  }
  return line + "\n";
}

}  // namespace

RunLog::RunLog(core::ProgressSink& outer, const std::string& folder, bool goesOn)
    : core::ProgressSink(&outer),
      outer_(outer),
      file_((fs::path(folder) / "log.jsonl").string()),
      goesOn_(goesOn),
      begin_(core::wallSeconds()) {}

RunLog::~RunLog() {
  if (isEnded_ || !isOpen_) return;
  core::Value members;
  members.set("outcome", "failed");
  end(members);
}

void RunLog::progress(const std::string& task, double fraction, const std::string& reached) {
  outer_.progress(task, fraction, reached);
  // Every task's beginning and end, and between them a line a second at most.
  const auto known = told_.find(task);
  const bool isMilestone = known == told_.end() || (fraction >= 1 && known->second < 1);
  if (!isMilestone && core::wallSeconds() - lastLine_ < progressInterval) return;
  told_[task] = fraction;
  core::Value members;
  members.set("task", task);
  members.set("done", std::round(1000 * fraction) / 1000);
  members.set("reached", reached);
  event("progress", members);
}

void RunLog::note(const std::string& message) {
  outer_.note(message);
  core::Value members;
  members.set("message", message);
  event("note", members);
}

void RunLog::event(const std::string& kind, const core::Value& members) {
  const double now = core::wallSeconds();
  core::Value line;
  line.set("time", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
  line.set("elapsed_s", std::round(1000 * (now - begin_)) / 1000);
  line.set("event", kind);
  for (const auto& [key, value] : members.object()) line.set(key, value);
  pending_ += onOneLine(line);
  lastLine_ = now;
  if (isOpen_ || now - begin_ > firstWrite) write();
}

void RunLog::end(const core::Value& members) {
  event("end", members);
  isEnded_ = true;
  write();
}

// A log that cannot be written is no reason to end a run: what follows says why the disk will take no more.
void RunLog::write() {
  std::error_code ignored;
  fs::create_directories(fs::path(file_).parent_path(), ignored);
  const int begin = isOpen_ || goesOn_ ? O_APPEND : O_TRUNC;
  const core::Descriptor log(::open(file_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | begin, 0666));
  if (log.ok() && core::writeAll(log.get(), pending_)) {
    isOpen_ = true;
    pending_.clear();
  }
}

}  // namespace goniolux::pipeline
