#include "photometry/candela_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace goniolux::photometry {
namespace {

// Searchlights and lighthouses reach some 1e9 cd; a thousand times that is a misprint.
constexpr double largestCandela = 1e12;
// How far readings of one direction may part, as a fraction of the maximum, before it is worth a warning.
constexpr double agreement = 0.01;

void checkRanges(const CandelaTable& t) {
  switch (t.type) {
    case PhotometryType::c:
      checkAngles(t.vertical, "vertical angles (gamma) of photometry type C", 0, 180, t.verticalAt);
      checkAngles(t.horizontal, "horizontal angles (C) of photometry type C", 0, 360, t.horizontalAt);
      break;
    case PhotometryType::b:
      checkAngles(t.vertical, "vertical angles (V) of photometry type B", -180, 180, t.verticalAt);
      checkAngles(t.horizontal, "horizontal angles (H) of photometry type B", -90, 90, t.horizontalAt);
      break;
    case PhotometryType::a:
      checkAngles(t.vertical, "vertical angles (V) of photometry type A", -90, 90, t.verticalAt);
      checkAngles(t.horizontal, "horizontal angles (H) of photometry type A", -180, 180, t.horizontalAt);
      break;
  }
}

void checkCandelas(const CandelaTable& t) {
  if (!(t.factor > 0)) {
    throw core::InputError(
        t.candelasAt, "bad-multiplier",
        fmt::format("multiplier, ballast factors and lamp flux multiply to {}; they must be above 0", t.factor));
  }
  for (std::size_t i = 0; i < t.candelas.size(); ++i) {
    const double value = t.candelas[i];
    const std::size_t plane = i / t.vertical.size(), angle = i % t.vertical.size();
    const auto where = [&] {
      return fmt::format("candela of plane {} ({} degrees) at {} degrees", plane + 1, t.horizontal[plane],
                         t.vertical[angle]);
    };
    if (value < 0) {
      throw core::InputError(t.candelasAt, "negative-candela",
                             fmt::format("{} is {}; an intensity cannot be negative: correct it to 0", where(), value));
    }
    if (value * t.factor > largestCandela) {
      throw core::InputError(t.candelasAt, "candela-too-large",
                             fmt::format("{} is {} cd; no lamp comes near: check the value and the multiplier", where(),
                                         value * t.factor));
    }
  }
}

// Types A and B: LM-63 lets H begin at -90 or 0. Files that begin a little after 0 are taken as symmetric, constant up
// to there.
void closeLateralGap(CandelaTable& t, core::Diagnostics& warnings) {
  if (t.type == PhotometryType::c || t.horizontal.size() < 2 || t.horizontal.front() <= 1e-6) return;
  warnings.warning(
      t.horizontalAt, "horizontal-gap",
      fmt::format("the horizontal angles begin at {0}; taken as symmetric about 0, and constant from 0 to {0} degrees",
                  t.horizontal.front()));
  t.horizontal.insert(t.horizontal.begin(), 0.0);
  const std::vector<double> plane(t.candelas.begin(),
                                  t.candelas.begin() + static_cast<std::ptrdiff_t>(t.vertical.size()));
  t.candelas.insert(t.candelas.begin(), plane.begin(), plane.end());
}

// Flux of type C between the table's end at vertical angle `v` (an index) and gamma `to`, if its last values went on.
double missingFlux(const CandelaTable& t, std::size_t v, double to) {
  double mean = 0;
  for (std::size_t h = 0; h < t.horizontal.size(); ++h) mean += t.candelas[h * t.vertical.size() + v];
  mean *= t.factor / static_cast<double>(t.horizontal.size());
  return mean * 2 * core::pi * std::abs(std::cos(t.vertical[v] * core::degree) - std::cos(to * core::degree));
}

void warnOfVerticalRange(const CandelaTable& t, core::Diagnostics& warnings) {
  const double first = t.vertical.front(), last = t.vertical.back();
  if (t.type == PhotometryType::c) {
    const bool usual = (first == 0 && (last == 90 || last == 180)) || (first == 90 && last == 180);
    if (!usual) {
      warnings.warning(
          t.verticalAt, "vertical-range",
          fmt::format(
              "the vertical angles run from {} to {}, not to 90 or 180 degrees; 0 cd is taken outside: held on, "
              "the values at the ends would add {:.4g} lm",
              first, last,
              missingFlux(t, 0, first < 90 ? 0 : 90) + missingFlux(t, t.vertical.size() - 1, last <= 90 ? 90 : 180)));
    }
  } else if (first >= 0) {
    warnings.warning(
        t.verticalAt, "vertical-range",
        fmt::format("the vertical angles begin at {}: nothing is taken below the aim (0 cd), no symmetry is assumed",
                    first));
  }
}

// Planes of type C meet at gamma 0 and 180, and plane 0 stands where plane 360 does.
void warnOfDisagreement(const CandelaTable& t, core::Diagnostics& warnings) {
  const double maximum = *std::max_element(t.candelas.begin(), t.candelas.end());
  if (maximum <= 0) {
    warnings.warning(t.candelasAt, "no-light", "all candela values are 0: this luminaire gives no light");
    return;
  }
  if (t.type != PhotometryType::c || t.horizontal.size() < 2) return;
  const std::size_t n = t.vertical.size(), planes = t.horizontal.size();
  const auto warnOfPole = [&](std::size_t v, const char* name) {
    double low = t.candelas[v], high = low;
    for (std::size_t h = 1; h < planes; ++h) {
      low = std::min(low, t.candelas[h * n + v]);
      high = std::max(high, t.candelas[h * n + v]);
    }
    if (high - low <= agreement * maximum) return;
    warnings.warning(
        t.candelasAt, "pole-differs",
        fmt::format("at the {} the planes state {} to {} cd for one direction; each plane is used as it is", name,
                    low * t.factor, high * t.factor));
  };
  if (t.vertical.front() == 0) warnOfPole(0, "nadir");
  if (t.vertical.back() == 180) warnOfPole(n - 1, "zenith");
  if (std::abs(t.horizontal.back() - 360) > 1e-6) return;
  double largest = 0;
  for (std::size_t v = 0; v < n; ++v)
    largest = std::max(largest, std::abs(t.candelas[v] - t.candelas[(planes - 1) * n + v]));
  if (largest > agreement * maximum) {
    warnings.warning(
        t.candelasAt, "seam-differs",
        fmt::format("planes 0 and 360 are one plane but differ by up to {} cd; both are used, each on its side",
                    largest * t.factor));
  }
}

}  // namespace

void checkAngles(const std::vector<double>& angles, const std::string& what, double lowest, double highest,
                 const core::SourcePosition& at) {
  constexpr double tolerance = 1e-6;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (angles[i] < lowest - tolerance || angles[i] > highest + tolerance) {
      throw core::InputError(at, "angle-out-of-range",
                             fmt::format("{}: {} is outside {} to {} degrees", what, angles[i], lowest, highest));
    }
    if (i > 0 && !(angles[i] > angles[i - 1])) {
      throw core::InputError(
          at, "angles-not-ascending",
          fmt::format("{}: {} follows {}; they must ascend without repeats", what, angles[i], angles[i - 1]));
    }
  }
}

std::shared_ptr<const TabulatedDistribution> makeDistribution(CandelaTable table, core::Diagnostics& warnings) {
  if (table.vertical.size() < 2) {
    throw core::InputError(table.verticalAt, "bad-count",
                           "the table has fewer than two vertical angles; nothing can be interpolated between them");
  }
  checkRanges(table);
  closeLateralGap(table, warnings);
  if (!horizontalSymmetry(table.type, table.horizontal)) {
    throw core::InputError(
        table.horizontalAt, "horizontal-range",
        fmt::format("the horizontal angles run from {} to {}; type C needs 0 to 0, 90, 180 or 360, or 90 to 270, "
                    "types A and B need -90 or 0 to 90 degrees",
                    table.horizontal.front(), table.horizontal.back()));
  }
  checkCandelas(table);
  warnOfVerticalRange(table, warnings);
  warnOfDisagreement(table, warnings);
  if (table.type == PhotometryType::c && table.horizontal.size() > 1 && table.horizontal.back() > 180 + 1e-6 &&
      table.horizontal.front() < 1e-6 && table.horizontal.back() < 360 - 1e-6) {
    const double gap = 360 - table.horizontal.back();
    const double step = table.horizontal.back() - table.horizontal[table.horizontal.size() - 2];
    if (gap > 1.5 * step) {
      warnings.warning(table.horizontalAt, "horizontal-gap",
                       fmt::format("the last plane is at {} degrees; the {} degrees up to plane 0 are interpolated",
                                   table.horizontal.back(), gap));
    }
  }
  for (double& value : table.candelas) value *= table.factor;
  return std::make_shared<const TabulatedDistribution>(table.type, std::move(table.horizontal),
                                                       std::move(table.vertical), std::move(table.candelas));
}

std::string symmetryName(HorizontalSymmetry symmetry) {
  switch (symmetry) {
    case HorizontalSymmetry::rotational:
      return "rotational";
    case HorizontalSymmetry::quadrant:
      return "quadrant";
    case HorizontalSymmetry::aboutC0:
      return "C0-C180";
    case HorizontalSymmetry::aboutC90:
      return "C90-C270";
    case HorizontalSymmetry::lateral:
      return "lateral";
    case HorizontalSymmetry::none:
      break;
  }
  return "none";
}

}  // namespace goniolux::photometry
