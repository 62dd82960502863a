#include "photometry/transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "photometry/candela_table.h"

namespace goniolux::photometry {
namespace {

constexpr double tolerance = 1e-6;  // degrees; angles of files are decimal numbers

double wrapped(double degrees) {
  const double angle = degrees - 360 * std::floor(degrees / 360);
  return angle >= 360 - tolerance ? 0 : angle;
}

// The plane stated for an angle, if there is one.
const std::vector<double>* planeAt(const PlaneTable& table, double degrees) {
  const double angle = wrapped(degrees);
  for (std::size_t i = 0; i < table.planes.size(); ++i)
    if (std::abs(table.planes[i] - angle) < tolerance) return &table.candelas[i];
  return nullptr;
}

// True when every plane has an equal one at its mirrored angle.
template <typename Mirror>
bool isMirrored(const PlaneTable& table, const Mirror& mirror) {
  for (std::size_t i = 0; i < table.planes.size(); ++i) {
    const auto* other = planeAt(table, mirror(table.planes[i]));
    if (!other || *other != table.candelas[i]) return false;
  }
  return true;
}

}  // namespace

PlaneTable allPlanes(const TabulatedDistribution& d) {
  assert(d.type() == PhotometryType::c);
  const std::size_t n = d.verticalAngles().size();
  std::vector<std::pair<double, std::size_t>> at;  // angle, stated plane
  const std::vector<double>& stated = d.horizontalAngles();
  for (std::size_t h = 0; h < stated.size(); ++h) {
    at.emplace_back(stated[h], h);
    switch (d.symmetry()) {
      case HorizontalSymmetry::quadrant:
        at.emplace_back(180 - stated[h], h);
        at.emplace_back(180 + stated[h], h);
        at.emplace_back(360 - stated[h], h);
        break;
      case HorizontalSymmetry::aboutC0:
        at.emplace_back(360 - stated[h], h);
        break;
      case HorizontalSymmetry::aboutC90:
        at.emplace_back(stated[h] <= 180 ? 180 - stated[h] : 540 - stated[h], h);
        break;
      default:
        break;
    }
  }
  std::stable_sort(at.begin(), at.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  PlaneTable table;
  for (const auto& [angle, h] : at) {
    if (!table.planes.empty() && angle - table.planes.back() < tolerance) continue;
    table.planes.push_back(angle);
    std::vector<double> candelas(n);
    for (std::size_t v = 0; v < n; ++v) candelas[v] = d.candela(h, v);
    table.candelas.push_back(std::move(candelas));
  }
  if (table.planes.size() > 1 && table.planes.back() < 360 - tolerance) {
    table.planes.push_back(360);
    table.candelas.push_back(table.candelas.front());
  }
  return table;
}

std::shared_ptr<const TabulatedDistribution> reduced(const PlaneTable& table, const std::vector<double>& vertical) {
  const bool equal = std::all_of(table.candelas.begin(), table.candelas.end(),
                                 [&](const auto& plane) { return plane == table.candelas.front(); });
  const bool aboutC0 = isMirrored(table, [](double c) { return -c; });
  const bool aboutC90 = isMirrored(table, [](double c) { return 180 - c; });
  const auto has = [&](double c) { return planeAt(table, c) != nullptr; };
  double from = 0, to = 360;
  if (equal) {
    to = 0;
  } else if (aboutC0 && aboutC90 && has(0) && has(90)) {
    to = 90;
  } else if (aboutC0 && has(0) && has(180)) {
    to = 180;
  } else if (aboutC90 && has(90) && has(270)) {
    from = 90;
    to = 270;
  }
  std::vector<double> planes, candelas;
  for (std::size_t i = 0; i < table.planes.size(); ++i) {
    if (table.planes[i] < from - tolerance || table.planes[i] > to + tolerance) continue;
    if (equal && !planes.empty()) continue;
    // A closing plane that repeats the first is implied where the planes go on beyond 180.
    if (to == 360 && i + 1 == table.planes.size() && table.candelas[i] == table.candelas.front() && planes.back() > 180)
      continue;
    planes.push_back(table.planes[i]);
    candelas.insert(candelas.end(), table.candelas[i].begin(), table.candelas[i].end());
  }
  return std::make_shared<const TabulatedDistribution>(PhotometryType::c, std::move(planes), vertical,
                                                       std::move(candelas));
}

PhotometricFile turned(const PhotometricFile& file, double degrees) {
  PhotometricFile result = file;
  const TabulatedDistribution& d = *file.distribution;
  if (d.type() != PhotometryType::c) {
    throw core::InputError({file.file, 0, 0}, "not-supported",
                           "not supported: turning planes of photometry types A and B; turn the luminaire in the "
                           "project (\"turn\")");
  }
  const double turn = wrapped(degrees);
  if (turn == 0) return result;
  if (d.symmetry() != HorizontalSymmetry::rotational) {
    const PlaneTable old = allPlanes(d);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i + 1 < old.planes.size(); ++i) order.emplace_back(wrapped(old.planes[i] + turn), i);
    std::sort(order.begin(), order.end());
    PlaneTable table;
    // The interpolant needs a plane at 0: between two stated planes, their mixture.
    if (order.front().first > tolerance) {
      table.planes.push_back(0);
      std::vector<double> plane;
      for (const double v : d.verticalAngles()) plane.push_back(d.atAngles(-turn, v));
      table.candelas.push_back(std::move(plane));
    }
    for (const auto& [angle, i] : order) {
      table.planes.push_back(angle);
      table.candelas.push_back(old.candelas[i]);
    }
    table.planes.front() = 0;
    table.planes.push_back(360);
    table.candelas.push_back(table.candelas.front());
    result.distribution = reduced(table, d.verticalAngles());
    result.symmetry = symmetryName(result.distribution->symmetry());
  }
  const double quarters = turn / 90;
  if (std::abs(quarters - std::round(quarters)) > tolerance) {
    if (file.opening.length != file.opening.width) {
      result.warnings.warning({file.file, 0, 0}, "opening-not-turned",
                              fmt::format("a turn of {:g} degrees leaves the opening where it was", degrees));
    }
  } else if (static_cast<int>(std::round(quarters)) % 2 != 0) {
    result.opening.lengthAlongC90 = !file.opening.lengthAlongC90;
  }
  return result;
}

}  // namespace goniolux::photometry
