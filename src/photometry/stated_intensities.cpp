#include "photometry/stated_intensities.h"

#include <fmt/format.h>

#include <algorithm>

namespace goniolux::photometry {

CandelaTable tableOfIntensities(std::vector<StatedIntensity> list, const core::SourcePosition& at) {
  if (list.empty()) throw core::InputError(at, "no-intensities", "the list of intensities is empty; supply it");
  std::stable_sort(list.begin(), list.end(), [](const StatedIntensity& a, const StatedIntensity& b) {
    return a.h < b.h || (a.h == b.h && a.v < b.v);
  });
  CandelaTable table;
  table.horizontalAt = table.verticalAt = table.candelasAt = at;
  for (const StatedIntensity& each : list) {
    if (each.value < 0) {
      throw core::InputError(each.at, "negative-candela",
                             fmt::format("the intensity {} is below 0, which none can be; correct it", each.value));
    }
    if (table.horizontal.empty() || each.h != table.horizontal.back()) table.horizontal.push_back(each.h);
    if (each.h == list.front().h) table.vertical.push_back(each.v);
    table.candelas.push_back(each.value);
  }
  const std::size_t n = table.vertical.size();
  for (std::size_t i = 1; i < n; ++i) {
    if (table.vertical[i] > table.vertical[i - 1]) continue;
    throw core::InputError(list[i].at, "angles-not-ascending",
                           fmt::format("the intensity at h {}, v {} is stated twice", list[i].h, list[i].v));
  }
  std::size_t wrong = 0;
  while (wrong < list.size() && list[wrong].v == table.vertical[wrong % n] &&
         list[wrong].h == table.horizontal[std::min(wrong / n, table.horizontal.size() - 1)])
    ++wrong;
  if (wrong < list.size() || list.size() != table.horizontal.size() * n) {
    const StatedIntensity& near = list[std::min(wrong, list.size() - 1)];
    throw core::InputError(near.at, "table-incomplete",
                           fmt::format("the intensities do not fill a table of {} horizontal by {} vertical angles: "
                                       "one is missing or stated twice near h {}, v {}",
                                       table.horizontal.size(), n, near.h, near.v));
  }
  return table;
}

void closeBySymmetry(CandelaTable& table, std::string stated, core::Diagnostics& warnings) {
  stated.erase(std::remove(stated.begin(), stated.end(), ' '), stated.end());
  if (stated.empty() || table.horizontal.size() < 2) return;
  const double last = table.horizontal.back();
  const bool none = stated.ends_with("None") || stated.ends_with("Arb");
  if (none && last <= 180) {
    table.horizontal.push_back(360);
    const auto n = static_cast<std::ptrdiff_t>(table.vertical.size());
    const std::vector<double> plane(table.candelas.begin(), table.candelas.begin() + n);
    table.candelas.insert(table.candelas.end(), plane.begin(), plane.end());
    return;
  }
  const auto symmetry = horizontalSymmetry(PhotometryType::c, table.horizontal);
  if (none || !symmetry || *symmetry == HorizontalSymmetry::none) return;
  const bool bilateral = *symmetry == HorizontalSymmetry::aboutC0 || *symmetry == HorizontalSymmetry::aboutC90;
  if (stated.ends_with("Quad") && *symmetry == HorizontalSymmetry::quadrant) return;
  if (stated.find("Bi") != std::string::npos && bilateral) return;
  warnings.warning(table.horizontalAt, "symmetry-differs",
                   fmt::format("the file says {}, its angles run from {} to {}: read as {}", stated,
                               table.horizontal.front(), last, symmetryName(*symmetry)));
}

}  // namespace goniolux::photometry
