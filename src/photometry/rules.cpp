#include "photometry/rules.h"

#include <algorithm>

namespace goniolux::photometry {

const std::vector<std::string_view>& departureRules() {
  static const std::vector<std::string_view> list{
      "format-line-missing", "odd-format-line",  "free-text-label", "future-use",   "tilt-file-missing",
      "decimal-comma",       "blank-field",      "bad-conversion",  "no-lamp-flux", "negative-lumens",
      "negative-watts",      "vertical-range",   "horizontal-gap",  "seam-differs", "trailing-numbers",
      "trailing-text",       "symmetry-differs", "length-unit",     "tm33-dialect",
  };
  return list;
}

void refuseDepartures(const core::Diagnostics& warnings) {
  core::Diagnostics departures;
  for (const core::Diagnostic& d : warnings.all()) {
    const auto& rules = departureRules();
    if (std::find(rules.begin(), rules.end(), d.rule) == rules.end()) continue;
    departures.error(d.position, d.rule, d.message + " (refused because reading is strict)");
  }
  if (departures.hasErrors()) throw core::InputError(departures);
}

}  // namespace goniolux::photometry
