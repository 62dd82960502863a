#include "app/cli/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>

namespace goniolux::app {
namespace {

constexpr int exitUnfinished = 3;
std::atomic<core::ProgressSink*> running{nullptr};
static_assert(std::atomic<core::ProgressSink*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "a signal handler may use lock-free atomics only");

void onSignal(int) {
  core::ProgressSink* sink = running.load();
  if (sink == nullptr || sink->cancelled()) _exit(exitUnfinished);
  sink->cancel();
}

void handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;  // files are written on while the stage comes to its boundary
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

InterruptGuard::InterruptGuard(core::ProgressSink& sink) {
  running = &sink;
  handle(onSignal);
}

InterruptGuard::~InterruptGuard() {
  handle(SIG_DFL);
  running = nullptr;
}

}  // namespace goniolux::app
