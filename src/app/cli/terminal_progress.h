// Progress on standard error: a bar with the time left on a terminal, a plain line every few seconds elsewhere.
#pragma once

#include <chrono>
#include <string>

#include "core/progress.h"

namespace goniolux::app {

class TerminalProgress final : public core::ProgressSink {
 public:
  explicit TerminalProgress(bool quiet);
  ~TerminalProgress() override;

  void progress(const std::string& task, double fraction, const std::string& reached) override;
  void note(const std::string& message) override;

  /// Takes the bar off the screen; call before printing anything else.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  void drawBar(double fraction, const std::string& text);

  bool quiet_, terminal_;
  bool barIsShown_ = false;
  std::string task_;
  Clock::time_point taskBegan_{}, lastShown_{};
};

/// "12 s", "3 min 20 s", "1 h 05 min".
std::string durationText(double seconds);

}  // namespace goniolux::app
