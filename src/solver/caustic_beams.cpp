// The rays that Caustics sends out from small luminaires, and where they are looked for. Definitions of its members.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/quadric_intersect.h"
#include "solver/caustics.h"
#include "solver/crossing.h"
#include "solver/directions.h"
#include "solver/world_extent.h"

namespace goniolux::solver {

using core::Vec3;
using Kind = SpecularStep::Kind;

namespace {

// Directions in which a luminaire's beams are sent, when it is the only one, and the least of them.
constexpr std::size_t directionsOfAll = 16384, mostDirections = 8192, fewestDirections = 64;
// A source's radius over its distance from mirrors and glass: up to here it is taken for a few elements; beyond, paths
// meet its image often enough.
constexpr double smallness = 0.5;
constexpr double verySmall = 0.1;
constexpr std::uint32_t elementsOfSmall = 32, elementsOfVerySmall = 16, elementsOfAll = 512;
constexpr std::size_t mostTargets = 64, mostBeams = 400000;
constexpr double beamsOfFacet = 2;  // at least, for a mesh to be served
constexpr double evenShare = 0.25;  // of them go all around, the others towards mirrors and glass
constexpr int mostSteps = 24;
constexpr int mostPlainSteps = 3;          // plane mirrors and panes before the first curved mirror or solid glass
constexpr float negligible = 1e-4f;        // of a beam's light
constexpr double notableLoss = 1e-4;       // of all light sent, in chains that are cut short
constexpr double neighbours = 1.5;         // spacings: a beam is tried for places that lie so far beside it
constexpr double dispersedNeighbours = 4;  // the same where every wavelength goes its own way
constexpr double unseenShare = 0.02;       // of the accuracy asked for
constexpr int cells = 40;
constexpr double mostCubes = 400;  // that a beam is looked for in; one that is wider is looked at everywhere

// The i-th of n directions spread evenly over a cap about `axis` whose rim has this cosine (Fibonacci lattice).
Vec3 spread(const core::Frame& frame, double rim, std::size_t i, std::size_t n) {
  const double golden = 2.399963229728653;
  const double z = 1 - (1 - rim) * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
  const double r = std::sqrt(std::max(0.0, 1 - z * z)), angle = golden * static_cast<double>(i);
  return frame.toWorld({r * std::cos(angle), r * std::sin(angle), z});
}

}  // namespace

Caustics::Caustics(const scene::World& world, const tracer::Tracer& tracer, const SpecularChains::Bsdfs& bsdfs,
                   const LightList& lights, std::size_t nodes, std::size_t hero, double accuracy)
    : world_(world), lights_(lights), chains_(world, tracer, bsdfs, nodes), nodes_(nodes), hero_(hero) {
  // What has images in the list of lights, or lets light go straight on, is served by connections.
  const auto isTarget = [&](std::uint32_t surface, std::uint32_t primitive) {
    const reflection::Bsdf& bsdf = *bsdfs[world.surfaces[surface].material];
    if (!bsdf.isSpecular() || bsdf.largestReflectance() <= 0) return false;
    disperses_ = disperses_ || (bsdf.medium() != nullptr && bsdf.medium()->disperses);
    return bsdf.medium() != nullptr || (!bsdf.lobes().straight && lights.planeOf(primitive) == scene::none);
  };
  std::map<std::uint32_t, geometry::Bounds> objects;
  std::map<std::uint32_t, std::size_t> facets;
  for (std::uint32_t t = 0; t < world.triangles.size(); ++t)
    if (isTarget(world.triangleSurfaces[t], t)) {
      const std::uint32_t object = world.surfaces[world.triangleSurfaces[t]].object;
      mostFacets_ = std::max(mostFacets_, ++facets[object]);
      for (const std::uint32_t corner : world.triangles[t]) objects[object].add(world.vertices[corner]);
    }
  for (std::uint32_t p = 0; p < world.patches.size(); ++p)
    if (isTarget(world.patches[p].surface, static_cast<std::uint32_t>(world.triangles.size()) + p))
      objects[world.surfaces[world.patches[p].surface].object].add(geometry::boundsOf(world.patches[p].patch));
  for (const auto& [object, bounds] : objects) targets_.push_back(bounds);
  std::size_t place = 0;
  const std::vector<geometry::Bounds> instances = scene::instanceBounds(world);
  for (const scene::InstancedMesh& mesh : world.instanced) {
    const bool any = std::any_of(mesh.triangleSurfaces.begin(), mesh.triangleSurfaces.end(),
                                 [&](std::uint32_t surface) { return isTarget(surface, scene::none); });
    if (any) mostFacets_ = std::max(mostFacets_, mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.places.size(); ++i, ++place)
      if (any) targets_.push_back(instances[place]);
  }
  if (targets_.empty()) return;
  if (targets_.size() > mostTargets) {
    for (const geometry::Bounds& target : targets_) targets_.front().add(target);
    targets_.resize(1);
  }

  for (std::uint32_t i = 0; i < world.emitters.size(); ++i) addElements(i, false);
  if (!resolvesFacets()) {
    sources_.clear();
    elements_.clear();
    isServed_.clear();
    for (std::uint32_t i = 0; i < world.emitters.size(); ++i) addElements(i, true);
  }
  if (elements_.empty()) return;
  margin_ = disperses_ ? dispersedNeighbours : neighbours;
  std::uint64_t rays = 0;
  for (std::uint32_t element = 0; element < elements_.size(); ++element) sendOut(element, directionsOfEach(), rays);
  index();
  limitBrightness(accuracy);
}

std::size_t Caustics::directionsOfEach() const {
  return std::clamp(directionsOfAll / std::max<std::size_t>(elements_.size(), 1), fewestDirections, mostDirections);
}

// Every facet of a mesh has light of its own to send; those that no beam meets are not found.
bool Caustics::resolvesFacets() const {
  const double each = (1 - evenShare) * static_cast<double>(directionsOfEach()) / static_cast<double>(targets_.size());
  return each >= beamsOfFacet * static_cast<double>(mostFacets_);
}

// A source that is small as the mirrors and the glass see it becomes a few points; paths meet a large one.
void Caustics::addElements(std::uint32_t index, bool onlyUnseen) {
  const scene::LightSource& source = world_.emitters[index];
  const Vec3 center = source.bounds.center();
  const double radius = 0.5 * glm::length(source.bounds.extent());
  isServed_.push_back(false);
  if (!(source.emitter->flux() > 0) || source.luminaire == scene::none) return;  // emitting finishes: paths meet them
  double nearest = std::numeric_limits<double>::infinity();
  for (const geometry::Bounds& target : targets_) {
    const Vec3 outside = glm::max(glm::max(target.min - center, center - target.max), Vec3(0));
    nearest = std::min(nearest, std::max(glm::length(outside), 0.25 * glm::length(target.extent())));
  }
  if (source.hasGeometry && (onlyUnseen || radius > smallness * nearest)) return;
  isServed_.back() = true;
  const bool isPoint = radius <= 1e-9 * world_.radius;
  const std::uint32_t count =
      isPoint ? 1
              : std::clamp<std::uint32_t>(elementsOfAll / static_cast<std::uint32_t>(world_.emitters.size()), 1,
                                          radius <= verySmall * nearest ? elementsOfVerySmall : elementsOfSmall);
  sources_.push_back({index, static_cast<std::uint32_t>(elements_.size()), count});
  for (std::uint32_t k = 0; k < count; ++k) {
    const double v = 0.5 + 0.618033988749895 * k;
    elements_.push_back({index,
                         static_cast<std::uint32_t>(sources_.size() - 1),
                         center,
                         {(k + 0.5) / count, v - std::floor(v)},
                         1.0 / count,
                         isPoint ? 1.0 : 1e4 * radius});
  }
}

Caustics::Ray Caustics::leave(const Element& element, const Vec3& direction) const {
  // Seen from far away, any emitter's sample is one of its places and the intensity that this stands for.
  const Vec3 from = element.center + direction * element.far;
  const emitter::IncidentLight light = world_.emitters[element.source].emitter->sample(from, element.place);
  return {from + light.direction * light.distance,
          light.normalIlluminance * light.distance * light.distance * element.share};
}

void Caustics::sendOut(std::uint32_t element, std::size_t directions, std::uint64_t& rays) {
  const Vec3 center = elements_[element].center, aim = world_.emitters[elements_[element].source].emitter->aim();
  const auto cap = [&](const Vec3& axis, double rim, std::size_t count) {
    const core::Frame frame = frameAbout(axis);
    const double spacing = std::sqrt(2 * core::pi * (1 - rim) / static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 direction = spread(frame, rim, i, count);
      follow(element, direction, spacing, rays);
    }
  };
  const auto even = static_cast<std::size_t>(evenShare * static_cast<double>(directions));
  cap(aim, -1, even);
  const std::size_t each = std::max<std::size_t>((directions - even) / targets_.size(), 16);
  for (const geometry::Bounds& target : targets_) {
    const Vec3 way = target.center() - center;
    const double distance = glm::length(way), radius = 0.5 * glm::length(target.extent());
    if (distance <= radius * 1.001)
      cap(aim, -1, each);
    else
      cap(way / distance, std::sqrt(1 - radius * radius / (distance * distance)), each);
  }
}

// A ray on its way, with what is left of its light.
struct Caustics::Pending {
  Vec3 origin, direction;
  Media media{};
  std::vector<SpecularStep> steps;
  std::vector<float> filter;
  bool isPlain = true;  ///< only plane mirrors that have images, and panes
};

void Caustics::follow(std::uint32_t element, const Vec3& start, double spacing, std::uint64_t& rays) {
  const Ray ray = leave(elements_[element], start);
  if (!(ray.candela > 0)) return;
  sent_ += ray.candela * spacing * spacing;
  std::vector<Pending> waiting;
  waiting.push_back({chains_.leave(ray.origin, 2.0 * start), start, {}, {}, std::vector<float>(nodes_, 1.0f)});
  SpecularChains::Encounter met;
  while (!waiting.empty()) {
    const Pending now = std::move(waiting.back());
    waiting.pop_back();
    const bool hits = chains_.meet(now.origin, now.direction, now.media, met, rays);
    if (!now.isPlain && addBeam(element, start, spacing, now.steps, hits ? met.distance : 4 * world_.radius) && hits)
      land(beams_.back(), ray.candela * spacing * spacing * static_cast<double>(now.filter[hero_]));
    if (!hits || !met.isSpecular) continue;
    const auto count = static_cast<int>(now.steps.size());
    if (now.isPlain && count >= mostPlainSteps) continue;
    if (count >= mostSteps || beams_.size() >= mostBeams) {
      dropped_ += ray.candela * spacing * spacing *
                  static_cast<double>(*std::max_element(now.filter.begin(), now.filter.end()));
      continue;
    }
    const Vec3 normal = met.fromInside ? -met.hit.normal : met.hit.normal;
    const auto branch = [&](Kind kind) {
      const SpecularStep step = chains_.stepAt(met, kind);
      Pending next{met.hit.position, now.direction, chains_.mediaAfter(met, kind), now.steps, now.filter, now.isPlain};
      chains_.absorb(step.here, met.distance, next.filter.data());
      chains_.applyStep(step, -glm::dot(normal, now.direction), next.filter.data());
      if (*std::max_element(next.filter.begin(), next.filter.end()) < negligible) return;
      if (!SpecularChains::bend(step, normal, hero_, next.direction)) return;
      const Vec3 side = kind == Kind::reflected ? normal : -normal;
      next.origin = chains_.leave(next.origin, side);
      next.isPlain = now.isPlain && !step.isInterface &&
                     (kind == Kind::straight || lights_.planeOf(met.hit.primitive) != scene::none);
      next.steps.push_back(step);
      waiting.push_back(std::move(next));
    };
    branch(Kind::reflected);
    if (met.here != met.beyond)
      branch(Kind::refracted);
    else if (chains_.isPane(met))
      branch(Kind::straight);
  }
}

bool Caustics::addBeam(std::uint32_t element, const Vec3& start, double spacing, const std::vector<SpecularStep>& steps,
                       double reach) {
  Beam beam;
  beam.element = element;
  beam.start = start;
  beam.spacing = spacing;
  beam.reach = reach;
  ChainEnd end;
  if (!differentiate(element, steps, start, hero_, Sharpness::rough, end, beam.originBy, beam.alongBy)) return false;
  beam.origin = end.origin;
  beam.along = end.direction;
  beam.firstStep = static_cast<std::uint32_t>(steps_.size());
  beam.steps = static_cast<std::uint32_t>(steps.size());
  steps_.insert(steps_.end(), steps.begin(), steps.end());
  beam.kind = kindOf(element, steps);
  beams_.push_back(beam);
  return true;
}

void Caustics::land(const Beam& beam, double flux) {
  const Vec3 place = beam.origin + beam.along * beam.reach;
  const Crossing c = crossingAt(place, beam.origin, beam.along, beam.originBy, beam.alongBy, beam.reach);
  const double area = std::abs(c.determinant()) * beam.spacing * beam.spacing;
  // As bright as if the element stood for its whole source.
  landings_.push_back({flux, flux / std::max(area * elements_[beam.element].share, 1e-300)});
}

// Beams stand for the light about them; those beyond the limit, brightest first, lose what exceeds it.
void Caustics::limitBrightness(double accuracy) {
  std::sort(landings_.begin(), landings_.end(),
            [](const Landing& a, const Landing& b) { return a.illuminance > b.illuminance; });
  double allowed = 0, flux = 0, inverse = 0;
  for (const scene::LightSource& source : world_.emitters) allowed += unseenShare * accuracy * source.emitter->flux();
  for (const Landing& landing : landings_) {
    // Lost with this one's illuminance as the limit.
    if (flux - landing.illuminance * inverse > allowed) break;
    brightest_ = landing.illuminance;
    flux += landing.flux;
    inverse += landing.flux / landing.illuminance;
  }
  landings_ = {};
}

// Chains of one element over the same finishes in the same way.
std::uint32_t Caustics::kindOf(std::uint32_t element, const std::vector<SpecularStep>& steps) {
  std::vector<std::uint32_t> name{element};
  for (const SpecularStep& step : steps) name.push_back(4 * step.surface + static_cast<std::uint32_t>(step.kind));
  return kinds_.emplace(std::move(name), static_cast<std::uint32_t>(kinds_.size())).first->second;
}

void Caustics::index() {
  places_ = PlaceIndex(boundsOf(world_), cells);
  const double step = places_.cellSize();
  for (std::uint32_t i = 0; i < beams_.size(); ++i) {
    const Beam& beam = beams_[i];
    const double wide = margin_ * beam.spacing;
    const auto corners = [&](double t, geometry::Bounds& box) {
      const Vec3 middle = beam.origin + beam.along * t;
      const Vec3 u = (beam.originBy[0] + beam.alongBy[0] * t) * wide,
                 v = (beam.originBy[1] + beam.alongBy[1] * t) * wide;
      for (const double a : {-1.0, 1.0})
        for (const double b : {-1.0, 1.0}) box.add(middle + u * a + v * b);
    };
    // The beams beside it may go a little farther.
    const double reach = beam.reach + 2 * step;
    double cubes = 0;
    for (double t = 0; t < reach && cubes <= mostCubes; t += step) {
      geometry::Bounds box;
      corners(t, box);
      corners(t + step, box);
      const Vec3 sides = box.extent() / step + Vec3(1);
      cubes += 0.5 * sides.x * sides.y * sides.z;  // most are shared with the next box
    }
    if (cubes > mostCubes) {
      wide_.push_back(i);
      continue;
    }
    for (double t = 0; t < reach; t += step) {
      geometry::Bounds box;
      corners(t, box);
      corners(t + step, box);
      places_.add(i, box);
    }
  }
  places_.finish();
}

std::vector<std::string> Caustics::leftOut() const {
  std::vector<std::string> sentences;
  if (!elements_.empty() && !resolvesFacets())
    sentences.emplace_back("some light of point and line luminaires by mirrors and glass of many facets");
  if (dropped_ > notableLoss * sent_)
    sentences.emplace_back("light of small luminaires after more than " + std::to_string(mostSteps) +
                           " reflections and refractions in a row");
  return sentences;
}

}  // namespace goniolux::solver
