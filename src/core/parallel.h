// The only place that makes threads. Work is cut into numbered items; what an item computes depends on its number
// alone, so the thread count never changes a digit. Threads are std::jthread: races stay visible to the thread
// sanitizer, which Debian's TBB hides (docs/decisions/0001-threads.md).
#pragma once

#include <cstddef>
#include <functional>

namespace goniolux::core {

/// Sets how many threads parallelFor uses; 0 = as many as the machine has. Call before work starts.
void setThreadCount(int count);
int threadCount();

/// Calls body(begin, end) for consecutive ranges of at most `grain` items that cover 0..count-1, on all threads, and
/// returns when all are done. The first exception thrown by a body is thrown again here, after the other threads have
/// stopped.
void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

/// CPU seconds of the whole process so far, all threads.
double processCpuSeconds();
/// A clock that never goes back, s; its zero means nothing.
double wallSeconds();

}  // namespace goniolux::core
