// Ctrl-C: the first asks the running stage to stop at its next batch boundary and keep what it has; the second ends at
// once.
#pragma once

#include "core/progress.h"

namespace goniolux::app {

/// While it lives, SIGINT and SIGTERM cancel `sink`. One at a time.
class InterruptGuard {
 public:
  explicit InterruptGuard(core::ProgressSink& sink);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

}  // namespace goniolux::app
