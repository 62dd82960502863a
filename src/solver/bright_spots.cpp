#include "solver/bright_spots.h"

#include <algorithm>
#include <cmath>

#include "solver/directions.h"

namespace goniolux::solver {

using core::Vec3;

namespace {

constexpr double leastGain = 8;  // of what the spots add to the relative variance of a cosine-chosen direction
constexpr std::size_t mostSpots = 128;
constexpr double largestShare = 0.5, smallestShare = 0.1;

/// About a normal, with x along an axis of the scene as far as the plane allows.
core::Frame alignedFrame(const Vec3& normal) {
  const Vec3 a = glm::abs(normal);
  Vec3 axis(0);
  axis[a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2] = 1;
  core::Frame frame;
  frame.z = normal;
  frame.x = glm::normalize(axis - normal * glm::dot(axis, normal));
  frame.y = glm::cross(frame.z, frame.x);
  return frame;
}

void sortAlong(LandedLight* first, std::size_t count, const Vec3& axis) {
  std::stable_sort(first, first + count, [&](const LandedLight& a, const LandedLight& b) {
    return glm::dot(a.position, axis) < glm::dot(b.position, axis);
  });
}

int facing(const Vec3& normal) {
  const Vec3 a = glm::abs(normal);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  return 2 * axis + (normal[axis] < 0 ? 1 : 0);
}

}  // namespace

// Of a few arrivals the brightness is known to a third, and chance alone seems to concentrate them.
const BrightSpots::Detail BrightSpots::coarse{12, 8, 1.5};
const BrightSpots::Detail BrightSpots::fine{96, 3, 1.15};

BrightSpots::BrightSpots(std::vector<LandedLight> landed, double area, const Detail& detail) {
  std::stable_sort(landed.begin(), landed.end(), [](const LandedLight& a, const LandedLight& b) {
    return a.surface != b.surface ? a.surface < b.surface : facing(a.normal) < facing(b.normal);
  });
  double light = 0;
  for (const LandedLight& l : landed) light += l.reflected;
  if (!(light > 0) || !(area > 0)) return;
  // No spot is left out for there being many: they are cut less finely then.
  for (std::size_t fewest = detail.fewest;; fewest *= 2) {
    spots_.clear();
    double all = light * light / area, bright = 0;
    for (std::size_t i = 0, next = 0; i < landed.size(); i = next) {
      while (next < landed.size() && landed[next].surface == landed[i].surface &&
             facing(landed[next].normal) == facing(landed[i].normal))
        ++next;
      for (const Spot& s : partsOf(landed.data() + i, next - i, fewest, detail.worthParting)) {
        all += s.spread();
        if (s.reflected / s.area < detail.brighter * light / area) continue;
        bright += s.spread();
        spots_.push_back(s);
      }
    }
    share_ = std::clamp(largestShare * bright / all, smallestShare, largestShare);
    if (bright * area < leastGain * light * light) spots_.clear();
    if (spots_.size() <= mostSpots) break;
  }
}

BrightSpots::Spot BrightSpots::around(const LandedLight* first, std::size_t count) {
  Spot spot;
  spot.surface = first->surface;
  Vec3 normal(0);
  for (std::size_t i = 0; i < count; ++i) normal += first[i].normal, spot.reflected += first[i].reflected;
  spot.normal = glm::normalize(normal);
  // Its sides along the axes as far as the plane allows: so do the edges of most of what is built.
  const core::Frame frame = alignedFrame(spot.normal);
  Vec3 low(1e300), high(-1e300);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 local = frame.toLocal(first[i].position - first->position);
    low = glm::min(low, local);
    high = glm::max(high, local);
  }
  // As far beyond the outermost arrivals as evenly spread ones would leave it.
  const double grow = static_cast<double>(count + 1) / static_cast<double>(count - 1);
  const Vec3 half = glm::max(0.5 * grow * (high - low), Vec3(1e-6));
  spot.center = first->position + frame.toWorld(0.5 * (low + high));
  spot.halfU = frame.toWorld({half.x, 0, 0});
  spot.halfV = frame.toWorld({0, half.y, 0});
  spot.area = 4 * half.x * half.y;
  spot.radius = std::hypot(half.x, half.y);
  return spot;
}

std::vector<BrightSpots::Spot> BrightSpots::partsOf(LandedLight* first, std::size_t count, std::size_t fewest,
                                                    double worthParting) {
  if (count < fewest) return {};
  const Spot whole = around(first, count);
  if (count < 2 * fewest) return {whole};
  // Cut where it concentrates the light most: both parts then hug what is bright.
  const core::Frame frame = alignedFrame(whole.normal);
  double best = 0;
  std::size_t cut = 0;
  Vec3 bestAxis(0);
  std::vector<double> before(count);
  for (const Vec3& axis : {frame.x, frame.y}) {
    const Vec3 other = glm::cross(whole.normal, axis);
    sortAlong(first, count, axis);
    const auto sweep = [&](bool forwards, auto&& visit) {
      double light = 0, low = 1e300, high = -1e300;
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = forwards ? k : count - 1 - k;
        light += first[i].reflected;
        const double across = glm::dot(first[i].position, other);
        low = std::min(low, across);
        high = std::max(high, across);
        const double length = std::abs(glm::dot(first[i].position - first[forwards ? 0 : count - 1].position, axis));
        visit(k, light * light / std::max(length * (high - low), 1e-12));
      }
    };
    sweep(true, [&](std::size_t k, double spread) { before[k] = spread; });
    sweep(false, [&](std::size_t k, double spread) {
      const std::size_t ahead = count - 1 - k;  // arrivals before this one
      if (k + 1 < fewest || ahead < fewest || before[ahead - 1] + spread <= best) return;
      best = before[ahead - 1] + spread;
      cut = ahead;
      bestAxis = axis;
    });
  }
  sortAlong(first, count, bestAxis);
  std::vector<Spot> parts = partsOf(first, cut, fewest, worthParting);
  const std::vector<Spot> others = partsOf(first + cut, count - cut, fewest, worthParting);
  parts.insert(parts.end(), others.begin(), others.end());
  // What is evenly bright stays whole.
  double spread = 0;
  for (const Spot& s : parts) spread += s.spread();
  if (spread < worthParting * whole.spread()) return {whole};
  return parts;
}

double BrightSpots::importance(const Spot& spot, const Vec3& origin, const Vec3& normal) {
  const Vec3 to = spot.center - origin;
  const double distance = std::max(glm::length(to), 1e-12), spread = std::min(1.0, spot.radius / distance);
  const double cosine = glm::dot(to, normal) / distance;
  if (cosine <= -spread) return 0;
  const double facing = std::max(cosine, 0.25 * (cosine + spread));
  const double slant = std::max(-glm::dot(to, spot.normal) / distance, 0.1 * spread);
  return spot.reflected * facing * slant / std::max(distance * distance, spot.radius * spot.radius);
}

BrightSpots::Choice BrightSpots::from(const Vec3& origin, const Vec3& normal) const {
  Choice choice{origin, normal, 0};
  for (const Spot& spot : spots_) choice.total += importance(spot, origin, normal);
  return choice;
}

bool BrightSpots::direction(const Choice& choice, double u, const core::Vec2& place, Vec3& direction,
                            std::uint32_t& surface) const {
  double left = u * choice.total;
  const Spot* chosen = nullptr;
  for (const Spot& spot : spots_) {
    const double share = importance(spot, choice.origin, choice.normal);
    if (share <= 0) continue;
    chosen = &spot;
    if (left < share) break;
    left -= share;
  }
  if (chosen == nullptr) return false;
  const Vec3 to =
      chosen->center + (2 * place.x - 1) * chosen->halfU + (2 * place.y - 1) * chosen->halfV - choice.origin;
  const double distance = glm::length(to);
  if (!(distance > 0) || glm::dot(to, choice.normal) <= 0) return false;
  direction = to / distance;
  surface = chosen->surface;
  return true;
}

double BrightSpots::density(const Choice& choice, const Vec3& direction, std::uint32_t surface) const {
  double sum = 0;
  const auto first = std::lower_bound(spots_.begin(), spots_.end(), surface,
                                      [](const Spot& spot, std::uint32_t s) { return spot.surface < s; });
  for (auto spot = first; spot != spots_.end() && spot->surface == surface; ++spot) {
    const double slant = glm::dot(direction, spot->normal);
    if (slant == 0) continue;
    const double distance = glm::dot(spot->center - choice.origin, spot->normal) / slant;
    if (!(distance > 0)) continue;
    const Vec3 place = choice.origin + distance * direction - spot->center;
    if (std::abs(glm::dot(place, spot->halfU)) > glm::dot(spot->halfU, spot->halfU) ||
        std::abs(glm::dot(place, spot->halfV)) > glm::dot(spot->halfV, spot->halfV))
      continue;
    sum += importance(*spot, choice.origin, choice.normal) * distance * distance / (std::abs(slant) * spot->area);
  }
  return choice.total > 0 ? sum / choice.total : 0;
}

}  // namespace goniolux::solver
