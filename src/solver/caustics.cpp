#include "solver/caustics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/crossing.h"

namespace goniolux::solver {

using core::Vec2;
using core::Vec3;

namespace {

constexpr double differenceStep = 1e-5;  // rad: errors of 1e-10 and 1e-11 relative
constexpr int mostNewtonSteps = 12;
constexpr int mostFailures = 3;         // of beams whose chains have the same steps, at one place
constexpr double sameSolution = 0.5;    // spacings: a beam that points so close to what is found is not followed
constexpr double sameDirection = 1e-7;  // rad

// Along the perpendiculars of a direction, rad.
Vec3 moved(const Vec3& direction, const Vec2& by) {
  Vec3 u, v;
  core::perpendiculars(direction, u, v);
  return glm::normalize(direction + u * by.x + v * by.y);
}

// Where this crossing would be solved lies within a number of spacings.
bool isNear(const Crossing& c, double reach) {
  const double sizes = glm::length(c.byU) * glm::length(c.byV);
  if (std::abs(c.determinant()) < 1e-3 * sizes)  // a focus: the derivatives say little
    return glm::length(c.error) <= reach * (glm::length(c.byU) + glm::length(c.byV));
  const Vec2 step = c.solution();
  return std::abs(step.x) <= reach && std::abs(step.y) <= reach;
}

}  // namespace

bool Caustics::differentiate(std::uint32_t element, std::span<const SpecularStep> steps, const Vec3& start,
                             std::size_t node, Sharpness sharpness, ChainEnd& end, Vec3 (&originBy)[2],
                             Vec3 (&alongBy)[2]) const {
  const auto run = [&](const Vec3& direction, ChainEnd& at) {
    return chains_.run(steps, leave(elements_[element], direction).origin, direction, node, at);
  };
  if (!run(start, end)) return false;
  Vec3 axis[2];
  core::perpendiculars(start, axis[0], axis[1]);
  for (int i = 0; i < 2; ++i) {
    ChainEnd more, less;
    const bool up = run(glm::normalize(start + axis[i] * differenceStep), more);
    const bool down =
        (sharpness == Sharpness::sharp || !up) && run(glm::normalize(start - axis[i] * differenceStep), less);
    if (!up && !down) return false;
    if (!up) more = end;
    if (!down) less = end;
    const double width = (up && down ? 2 : 1) * differenceStep;
    originBy[i] = (more.origin - less.origin) / width;
    alongBy[i] = (more.direction - less.direction) / width;
  }
  return true;
}

bool Caustics::aim(const Beam& beam, const Vec3& place, std::size_t node, Vec3 start, Solution& found) const {
  const auto steps = stepsOf(beam);
  ChainEnd& end = found.end;
  Vec3 originBy[2], alongBy[2];
  const double precise = 1e-11 * world_.radius, close = 1e-8 * world_.radius;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < mostNewtonSteps; ++i) {
    if (!differentiate(beam.element, steps, start, node, Sharpness::rough, end, originBy, alongBy)) return false;
    const double t = glm::dot(place - end.origin, end.direction);
    if (!(t > 0)) return false;
    const Crossing c = crossingAt(place, end.origin, end.direction, originBy, alongBy, t);
    const double error = glm::length(c.error);
    // As sharp as rounding allows: it does not get better any more.
    if (error <= precise || (error < close && error >= 0.5 * last)) {
      found.start = start;
      if (!differentiate(beam.element, steps, start, node, Sharpness::sharp, end, originBy, alongBy)) return false;
      found.area = std::abs(crossingAt(place, end.origin, end.direction, originBy, alongBy, t).determinant());
      return found.area > 0;
    }
    last = error;
    if (c.determinant() == 0) return false;
    Vec2 step = c.solution();
    const double length = glm::length(step), most = beam.spacing;
    if (!std::isfinite(length)) return false;
    if (length > most) step *= most / length;
    start = moved(start, step);
    // Beyond the beams beside it: theirs to find.
    if (glm::distance(start, beam.start) > 2 * margin_ * beam.spacing) return false;
  }
  return false;
}

// Beams near by lead to the same solutions: the one that promises most is followed, and those that point to what has
// been found already only confirm it.
void Caustics::arrivals(const Vec3& place, std::size_t node, double draw, std::vector<Arrival>& found,
                        std::uint64_t& rays) const {
  found.clear();
  const auto isDrawn = [&](std::uint32_t element) {
    if (draw < 0) return true;
    const Source& source = sources_[elements_[element].of];
    return element == source.first + std::min(source.count - 1, static_cast<std::uint32_t>(draw * source.count));
  };
  struct Candidate {
    std::uint32_t beam, kind;
    double score;  ///< how far off in spacings
    Vec3 start;    ///< promised
  };
  thread_local std::vector<Candidate> candidates;
  candidates.clear();
  const auto consider = [&](std::uint32_t i) {
    const Beam& beam = beams_[i];
    if (!isDrawn(beam.element)) return;
    const double t = glm::dot(place - beam.origin, beam.along);
    if (!(t > 0)) return;
    const Crossing c = crossingAt(place, beam.origin, beam.along, beam.originBy, beam.alongBy, t);
    if (!isNear(c, margin_ * beam.spacing)) return;
    Vec2 step = c.solution();
    const double off = glm::length(step) / beam.spacing;
    if (!(off <= 2 * margin_)) step = Vec2(0);
    candidates.push_back({i, beam.kind, std::isfinite(off) ? off : margin_, moved(beam.start, step)});
  };
  for (const std::uint32_t i : places_.at(place)) consider(i);
  for (const std::uint32_t i : wide_) consider(i);
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.score != b.score ? a.score < b.score : a.beam < b.beam;
  });
  std::uint32_t kind = scene::none;
  int failures = 0;
  for (const Candidate& candidate : candidates) {
    const Beam& beam = beams_[candidate.beam];
    if (candidate.kind != kind) failures = 0;
    kind = candidate.kind;
    if (failures > mostFailures) continue;
    const auto nearby = [&](const Vec3& start, double distance) {
      return std::find_if(found.begin(), found.end(), [&](const Arrival& known) {
        return beams_[known.beam].kind == kind && glm::distance(known.start, start) <= distance;
      });
    };
    if (const auto known = nearby(candidate.start, sameSolution * beam.spacing); known != found.end()) {
      known->isLone = false;
      continue;
    }
    Solution solution;
    if (!aim(beam, place, node, candidate.start, solution)) {
      ++failures;
      continue;
    }
    if (const auto known = nearby(solution.start, sameDirection); known != found.end()) {
      known->isLone = false;
      continue;
    }
    const Element& element = elements_[beam.element];
    const Ray ray = leave(element, solution.start);
    if (!(ray.candela > 0) || !chains_.confirm(stepsOf(beam), chains_.leave(ray.origin, 2.0 * solution.start),
                                               solution.start, node, place, rays)) {
      ++failures;
      continue;
    }
    const double candela = draw < 0 ? ray.candela : ray.candela / element.share;
    found.push_back({element.source, beam.element, -solution.end.direction, candela / solution.area, true,
                     solution.start, candidate.beam, glm::distance(place, solution.end.origin)});
  }
}

void Caustics::applyFilter(const Arrival& arrival, std::size_t node, float* filter) const {
  const Beam& beam = beams_[arrival.beam];
  const auto steps = stepsOf(beam);
  ChainEnd end;
  chains_.run(steps, leave(elements_[beam.element], arrival.start).origin, arrival.start, node, end, filter);
  chains_.absorb(steps.back().after(), arrival.distance, filter);
}

}  // namespace goniolux::solver
