// Progress and cancel: what a stage tells while it works, and how it is asked to stop.
#pragma once

#include <atomic>
#include <string>

namespace goniolux::core {

/// Receives what a stage reports. Called from the thread that runs the stage, never from several at once.
class ProgressSink {
 public:
  ProgressSink() = default;
  virtual ~ProgressSink() = default;

  /// `fraction` done of the task (0..1, monotone) and what is reached so far, e.g. "points within 1 %: 87 %".
  virtual void progress(const std::string& task, double fraction, const std::string& reached) = 0;
  /// A line worth keeping in the log.
  virtual void note(const std::string& message) = 0;

  /// True once the user asked to stop: a stage ends at its next batch boundary and keeps what it has.
  [[nodiscard]] bool cancelled() const {
    return cancelled_.load(std::memory_order_relaxed) || (outer_ != nullptr && outer_->cancelled());
  }
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }

 protected:
  /// A sink that passes on to another is cancelled with it.
  explicit ProgressSink(const ProgressSink* outer) : outer_(outer) {}

 private:
  std::atomic<bool> cancelled_{false};
  const ProgressSink* outer_ = nullptr;
};

/// Keeps nothing and shows nothing.
class SilentProgress final : public ProgressSink {
 public:
  void progress(const std::string&, double, const std::string&) override {}
  void note(const std::string&) override {}
};

}  // namespace goniolux::core
