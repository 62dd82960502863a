#include "project/summary_table.h"

#include <fmt/format.h>

namespace goniolux::project {

using core::Estimate;

std::string toSummaryTable(const Results& results) {
  // A tab or a line's end inside a name would begin another cell.
  const auto cell = [](std::string text) {
    for (char& c : text)
      if (c == '\t' || c == '\n' || c == '\r') c = ' ';
    return text;
  };
  const auto figures = [](const Estimate& e) {
    return "\t" + tableNumber(e.value) + "\t" + tableNumber(e.halfWidth());
  };
  std::string table =
      "name\tquantity\tunit\tmean\tmean_half_width\tmin\tmin_half_width\tmax\tmax_half_width\tu0\tu0_half_width\n";
  for (const GridResult& grid : results.grids)
    table += cell(grid.name) + "\t" + grid.quantity + "\t" + grid.unit + figures(grid.mean) + figures(grid.min) +
             figures(grid.max) + figures(grid.u0) + "\n";
  if (!results.observers.empty()) table += "\nname\tquantity\tunit\tvalue\thalf_width\n";
  for (const ObserverResult& observer : results.observers)
    table += cell(observer.name) + "\t" + observer.quantity + "\t1" + figures(observer.value) + "\n";
  if (!results.requirements.empty()) table += "\nrequirement\tverdict\tclause\n";
  for (const RequirementResult& requirement : results.requirements)
    table += cell(requirement.text) + "\t" + wordFor(requirement.verdict) + "\t" + cell(requirement.clause) + "\n";
  return table;
}

}  // namespace goniolux::project
