#include "core/work_items.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/parallel.h"

namespace goniolux::core {
namespace {

constexpr double sliceSeconds = 2;

// A record: what the slice cost, then item, length and bytes of each result.
void recover(const WorkItems& items, const Keeping& keeping, std::vector<char>& done, double& wall_s) {
  keeping.log->recover(keeping.name, [&](std::string_view record) {
    Spent spent;
    if (!take(record, spent)) return;
    std::uint64_t item = 0, bytes = 0;
    while (take(record, item) && take(record, bytes) && item < items.count && bytes <= record.size()) {
      if (done[item] == 0 && items.unpack(item, record.substr(0, bytes))) done[item] = 1;
      record.remove_prefix(bytes);
    }
    wall_s += spent.wall_s;
    keeping.log->addRecovered(spent);
  });
}

void keep(const WorkItems& items, const std::vector<std::size_t>& fresh, const Spent& spent, const Keeping& keeping) {
  std::string record, bytes;
  put(record, spent);
  for (const std::size_t item : fresh) {
    bytes.clear();
    items.pack(item, bytes);
    put(record, static_cast<std::uint64_t>(item));
    put(record, static_cast<std::uint64_t>(bytes.size()));
    record += bytes;
  }
  keeping.log->add(keeping.name, record);
  keeping.log->commitWhenDue();
}

}  // namespace

WorkDone doItems(const WorkItems& items, const Keeping& keeping, const ProgressSink& progress) {
  const bool isKept = keeping.log != nullptr && items.pack;
  std::vector<char> done(items.count, 0);
  WorkDone result;
  if (isKept) recover(items, keeping, done, result.wall_s);
  std::vector<std::size_t> left(items.count);
  std::iota(left.begin(), left.end(), std::size_t{0});
  const auto isDone = [&](std::size_t item) { return done[item] != 0; };
  std::erase_if(left, isDone);

  while (!left.empty()) {
    if (progress.cancelled()) return result;
    const double start = wallSeconds(), cpuAtStart = processCpuSeconds();
    const std::uint64_t raysAtStart = isKept ? keeping.log->rays() : 0;
    parallelFor(left.size(), items.grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t j = begin; j < end; ++j) {
        if (progress.cancelled() || wallSeconds() - start > sliceSeconds) return;
        items.work(left[j]);
        done[left[j]] = 1;
      }
    });
    const double seconds = wallSeconds() - start;
    result.wall_s += seconds;
    std::vector<std::size_t> fresh;
    std::copy_if(left.begin(), left.end(), std::back_inserter(fresh), isDone);
    std::erase_if(left, isDone);
    if (isKept && !fresh.empty())
      keep(items, fresh, {seconds, processCpuSeconds() - cpuAtStart, keeping.log->rays() - raysAtStart}, keeping);
    if (items.told && !left.empty())
      items.told(1 - static_cast<double>(left.size()) / static_cast<double>(items.count));
  }
  result.complete = true;
  return result;
}

}  // namespace goniolux::core
