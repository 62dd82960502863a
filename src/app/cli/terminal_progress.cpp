#include "app/cli/terminal_progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace goniolux::app {
namespace {

constexpr auto barInterval = std::chrono::milliseconds(100);
constexpr auto lineInterval = std::chrono::seconds(5);

int terminalColumns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

double secondsBetween(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

std::string durationText(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

TerminalProgress::TerminalProgress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

TerminalProgress::~TerminalProgress() {
  clear();
}

void TerminalProgress::progress(const std::string& task, double fraction, const std::string& reached) {
  if (quiet_) return;
  const Clock::time_point now = Clock::now();
  if (task != task_) {
    task_ = task;
    taskBegan_ = now;
    if (!terminal_) lastShown_ = now;  // short tasks need no line
  }
  fraction = std::clamp(fraction, 0.0, 1.0);
  if (now - lastShown_ < (terminal_ ? Clock::duration(barInterval) : Clock::duration(lineInterval))) return;
  lastShown_ = now;

  std::string text = fmt::format("{:3.0f} %  {}", std::floor(100 * fraction), task);
  if (!reached.empty()) text += ": " + reached;
  // The time left is guessed from the pace so far, once there is something to guess from.
  const double elapsed = secondsBetween(taskBegan_, now);
  if (elapsed > 1 && fraction > 0.01 && fraction < 1)
    text += fmt::format(", {} left", durationText(elapsed * (1 - fraction) / fraction));
  if (terminal_)
    drawBar(fraction, text);
  else
    fmt::print(stderr, "{}\n", text);
}

void TerminalProgress::note(const std::string& message) {
  if (quiet_) return;
  clear();
  fmt::print(stderr, "{}\n", message);
}

void TerminalProgress::clear() {
  if (!barIsShown_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  barIsShown_ = false;
}

void TerminalProgress::drawBar(double fraction, const std::string& text) {
  constexpr int width = 24;
  const auto full = static_cast<std::size_t>(std::lround(fraction * width));
  std::string line = "[" + std::string(full, '#') + std::string(width - full, ' ') + "] " + text;
  // A line that wraps could not be drawn over: cut it, at a character's first byte.
  std::size_t end = std::min(line.size(), static_cast<std::size_t>(std::max(20, terminalColumns() - 1)));
  while (end < line.size() && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end;
  fmt::print(stderr, "\r\x1b[K{}", line.substr(0, end));
  std::fflush(stderr);
  barIsShown_ = true;
}

}  // namespace goniolux::app
