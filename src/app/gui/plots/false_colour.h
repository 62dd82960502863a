// FalseColour: how values become colours, in plan and in the 3-D view alike.
#pragma once

#include <string>
#include <vector>

namespace goniolux::gui {

struct FalseColour {
  std::string palette = "viridis";  ///< a name of plot::palettes()
  bool banded = true;               ///< one colour between two levels; otherwise a smooth passage
  std::vector<double> levels;       ///< of the isolux lines; empty: chosen from the values
};

}  // namespace goniolux::gui
