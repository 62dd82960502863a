#include "core/parallel.h"

#include <time.h>

#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace goniolux::core {
namespace {

std::atomic<int> chosenThreads{0};

// Denormals are flushed in every tracing thread: Embree asks for it, and nothing here lives below 1e-38.
void flushDenormals() {
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
}

}  // namespace

void setThreadCount(int count) {
  chosenThreads.store(std::max(0, count));
}

int threadCount() {
  const int chosen = chosenThreads.load();
  return chosen > 0 ? chosen : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  grain = std::max<std::size_t>(1, grain);
  const std::size_t ranges = (count + grain - 1) / grain;
  const std::size_t threads = std::min<std::size_t>(static_cast<std::size_t>(threadCount()), ranges);

  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failureLock;
  const auto work = [&] {
    flushDenormals();
    for (std::size_t range = next++; range < ranges; range = next++) {
      try {
        body(range * grain, std::min(count, (range + 1) * grain));
      } catch (...) {
        const std::scoped_lock lock(failureLock);
        if (!failure) failure = std::current_exception();
        next = ranges;
      }
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

double processCpuSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double wallSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace goniolux::core
