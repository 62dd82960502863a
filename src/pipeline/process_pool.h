// ProcessPool: several helper programs at once, each in a process of its own, so that one that crashes takes nothing
// with it. Used from one thread.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/helper_process.h"

namespace goniolux::pipeline {

class ProcessPool {
 public:
  struct Ended {
    std::size_t tag;
    ProcessEnd end;
    double seconds;  ///< wall clock
  };

  ProcessPool() = default;
  /// Kills what still runs.
  ~ProcessPool();
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;

  /// Starts a program as runHelper() does, in a process group of its own: Ctrl-C reaches only who started it. One that
  /// cannot be started is reported by the next wait().
  void start(std::size_t tag, const std::string& program, const std::vector<std::string>& arguments);
  [[nodiscard]] std::size_t running() const { return children_.size(); }
  /// The next one that ends, waiting for it at most so long.
  std::optional<Ended> wait(double seconds);
  void killAll();

 private:
  using Clock = std::chrono::steady_clock;
  struct Child {
    std::size_t tag;
    StartedProcess process;
    std::string errors;
    Clock::time_point began;
  };
  std::vector<Child> children_;
};

}  // namespace goniolux::pipeline
