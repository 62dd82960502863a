// Work items: the pieces that long work is cut into. An item's result is a pure function of its number (and of what all
// items had to begin with), so items can be done in any order, by any number of threads, in several runs.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "core/kept_work.h"
#include "core/progress.h"

namespace goniolux::core {

struct WorkItems {
  std::size_t count = 0;
  std::size_t grain = 1;  ///< items that a thread takes at once
  /// Does an item, on any thread.
  std::function<void(std::size_t item)> work;
  /// Appends an item's result to bytes that are kept. Without it nothing is kept.
  std::function<void(std::size_t item, std::string& bytes)> pack = {};
  /// Takes an item's result from such bytes; false when they do not fit what is wanted now: then it is done anew.
  std::function<bool(std::size_t item, std::string_view bytes)> unpack = {};
  /// Told the share of the items that is done, every few seconds, on the calling thread.
  std::function<void(double share)> told = {};
};

struct WorkDone {
  bool complete = false;  ///< false: cancelled before the last item
  double wall_s = 0;      ///< that the items took, also those that an earlier run did
};

/// Does all the items that are not kept from before, in slices of a few seconds after which they are kept, and after
/// which it ends when cancelled.
WorkDone doItems(const WorkItems& items, const Keeping& keeping, const ProgressSink& progress);

}  // namespace goniolux::core
