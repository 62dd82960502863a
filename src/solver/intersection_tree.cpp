#include "solver/intersection_tree.h"

#include <algorithm>
#include <cmath>

namespace goniolux::solver {

using core::Vec3;

namespace {

core::Frame frameAbout(const Vec3& normal) {
  core::Frame frame;
  frame.z = normal;
  core::perpendiculars(normal, frame.x, frame.y);
  return frame;
}

reflection::Interface interfaceOf(const TreeNode& node, std::size_t hero) {
  reflection::Interface at;
  if (node.here != nullptr) at.indexHere = node.here->index.data();
  if (node.beyond != nullptr) at.indexBeyond = node.beyond->index.data();
  at.hero = hero;
  return at;
}

double largestOf(const std::vector<float>& values) {
  return static_cast<double>(*std::max_element(values.begin(), values.end()));
}

}  // namespace

LuminanceScale luminanceScale(const scene::World& world) {
  constexpr std::uint32_t points = 2048;
  LuminanceScale scale{0, 0, 0};
  for (const scene::Surface& surface : world.surfaces) scale.lamp = std::max(scale.lamp, surface.luminance);
  std::vector<double> areas;
  double total = 0;
  for (const auto& t : world.triangles) {
    const Vec3 &a = world.vertices[t[0]], &b = world.vertices[t[1]], &c = world.vertices[t[2]];
    areas.push_back(total += 0.5 * glm::length(glm::cross(b - a, c - a)));
  }
  double mean = 0, largest = 0;
  for (std::uint32_t i = 0; i < points; ++i) {
    core::Sampler random(0x5ca1e, i);
    Vec3 point(0), normal(0, 0, 1);
    if (total > 0) {
      const auto found = std::upper_bound(areas.begin(), areas.end(), random.next() * total);
      const auto t = std::min(static_cast<std::size_t>(found - areas.begin()), areas.size() - 1);
      const auto& corner = world.triangles[t];
      const Vec3 &a = world.vertices[corner[0]], &b = world.vertices[corner[1]], &c = world.vertices[corner[2]];
      const core::Vec2 u = random.next2();
      const double root = std::sqrt(u.x);
      point = a * (1 - root) + b * (root * (1 - u.y)) + c * (root * u.y);
      normal = glm::normalize(glm::cross(b - a, c - a));
    }
    double e = 0;
    for (const scene::LightSource& source : world.emitters) {
      const emitter::IncidentLight light = source.emitter->sample(point, random.next2());
      e += light.normalIlluminance * std::abs(glm::dot(light.direction, normal));
      const double solidAngle = source.hasGeometry ? source.emitter->roughSolidAngle(point) : 0;
      if (solidAngle > 0) scale.lamp = std::max(scale.lamp, light.normalIlluminance / solidAngle);
    }
    mean += e / points;
    largest = std::max(largest, e);
  }
  scale.white = mean / core::pi;
  scale.matt = largest / core::pi;
  if (!(scale.white > 0)) scale.white = scale.matt = std::max(scale.lamp, 1.0);
  scale.lamp = std::max(scale.lamp, scale.white);
  return scale;
}

void TreeBuilder::build(const Vec3& origin, const Vec3& direction, core::Sampler& random,
                        IntersectionTree& tree) const {
  tree.clear();
  std::vector<Pending> waiting;
  waiting.push_back({-1, false, 1, origin, direction, {}, 1.0, false});
  while (!waiting.empty()) {
    const Pending next = waiting.back();
    waiting.pop_back();
    grow(next, random, tree, waiting);
  }
}

void TreeBuilder::grow(const Pending& ray, core::Sampler& random, IntersectionTree& tree,
                       std::vector<Pending>& waiting) const {
  Media media = ray.media;
  Vec3 origin = ray.origin;
  TreeNode node;
  tracer::Hit hit;
  std::uint32_t body = scene::none;
  bool fromInside = false;
  const reflection::Medium* own = nullptr;
  // On to the next surface that has different media on its sides, or none at all behind it.
  for (;;) {
    ++tree.rays;
    if (!tracer_.intersect(origin, ray.direction, hit)) return;
    node.distance += hit.distance;
    const scene::Surface& surface = world_.surfaces[hit.surface];
    node.material = surface.material;
    body = surface.object;
    own = shadings_[node.material]->medium();
    fromInside = glm::dot(hit.normal, ray.direction) > 0;
    if (own != nullptr && fromInside) media.enter(body, own);
    node.here = node.beyond = media.here();
    if (own == nullptr) break;
    Media past = media;
    fromInside ? past.leave(body) : past.enter(body, own);
    node.beyond = past.here();
    if (node.beyond != node.here) break;
    media = past;
    origin = tracer_.leave(hit.position, fromInside ? hit.normal : -hit.normal);
  }
  const Vec3 normal = fromInside ? -hit.normal : hit.normal;
  const core::Frame frame = frameAbout(normal);
  const scene::Surface& surface = world_.surfaces[hit.surface];
  node.out = frame.toLocal(-ray.direction);
  node.out.z = std::max(node.out.z, 0.0);
  node.depth = ray.depth;
  node.bound = ray.bound;
  node.forLampsOnly = ray.forLampsOnly;
  node.emitter = surface.emitter;
  if (surface.luminance > 0) {
    node.luminance = surface.luminance;
    node.spectrum = surface.spectrum;
  } else if (surface.emitter != scene::none) {
    const scene::LightSource& source = world_.emitters[surface.emitter];
    node.luminance = source.emitter->luminance(normal, -ray.direction);
    node.spectrum = source.spectrum;
  }
  const bool lamp = node.luminance > 0;

  const reflection::LocalShading& shading = *shadings_[node.material];
  const reflection::Interface at = interfaceOf(node, hero_);
  std::vector<float> reflected(count_), transmitted(count_, 0);
  shading.reflectedFactor(node.out, at, reflected.data());
  if (shading.transmits()) shading.transmittedFactor(node.out, at, transmitted.data());
  const double r = largestOf(reflected), t = largestOf(transmitted);
  if (node.forLampsOnly && !lamp) {
    tree.discarded += node.bound * scale_.matt;  // its own light is not looked at
    if (r <= 0 && t <= 0) return;
  }

  const auto index = static_cast<std::int32_t>(tree.nodes.size());
  if (ray.parent >= 0)
    (ray.transmitted ? tree.nodes[static_cast<std::size_t>(ray.parent)].transmitted
                     : tree.nodes[static_cast<std::size_t>(ray.parent)].reflected) = index;
  tree.deepest = std::max(tree.deepest, node.depth);
  if (!node.forLampsOnly) findArrivals(node, hit.position, normal, frame, random, tree);
  tree.nodes.push_back(node);

  const Vec3 mirrored = ray.direction - normal * (2 * glm::dot(ray.direction, normal));
  spawn({index, false, node.depth + 1, tracer_.leave(hit.position, normal), mirrored, media, node.bound * r, false}, r,
        lamp, tree, waiting);
  if (!shading.transmits()) return;
  Vec3 direction = ray.direction;
  if (shading.bends()) {
    const double index12 = at.beyond(hero_) / at.here(hero_), cosine = node.out.z;
    const double sineSquared = (1 - cosine * cosine) / (index12 * index12);
    if (sineSquared >= 1) return;  // total reflection
    direction = glm::normalize((ray.direction + normal * cosine) / index12 - normal * std::sqrt(1 - sineSquared));
  }
  Media past = media;
  if (own != nullptr) fromInside ? past.leave(body) : past.enter(body, own);
  spawn({index, true, node.depth + 1, tracer_.leave(hit.position, -normal), direction, past, node.bound * t, false}, t,
        lamp, tree, waiting);
}

void TreeBuilder::spawn(const Pending& child, double factor, bool lamp, IntersectionTree& tree,
                        std::vector<Pending>& waiting) const {
  if (lamp) return;  // a lamp ends its branch
  const bool tooDeep = child.depth > control_.maxDepth;
  if (!control_.adaptive) {
    if (!tooDeep)
      waiting.push_back(child);
    else
      tree.discarded += child.bound * scale_.lamp;
    return;
  }
  if (!(factor > 0)) return;
  // Bounds are products of a few factors: powers that meet the cut-off exactly must not fall to rounding.
  const double cutoff = control_.cutoff * (1 - 1e-9);
  if (tooDeep || child.bound * scale_.lamp / scale_.white < cutoff) {
    tree.discarded += child.bound * scale_.lamp;
    return;
  }
  waiting.push_back(child);
  waiting.back().forLampsOnly = child.bound < cutoff;
}

void TreeBuilder::findArrivals(TreeNode& node, const Vec3& point, const Vec3& normal, const core::Frame& frame,
                               core::Sampler& random, IntersectionTree& tree) const {
  node.firstArrival = tree.arrivals.size();
  if (!shadings_[node.material]->isLit()) return;
  const bool both = shadings_[node.material]->seesBehind();
  for (std::uint32_t i = 0; i < world_.emitters.size(); ++i) {
    const scene::LightSource& source = world_.emitters[i];
    if (!both && source.emitter->importance(point, normal) == 0) continue;
    const emitter::IncidentLight light = source.emitter->sample(point, random.next2());
    const double cosine = glm::dot(light.direction, normal);
    if (light.normalIlluminance <= 0 || cosine == 0 || (cosine < 0 && !both)) continue;
    const Vec3 start = tracer_.leave(point, cosine > 0 ? normal : -normal);
    const double share = seen(source, start, point + light.direction * light.distance, tree.rays);
    if (share > 0) tree.arrivals.push_back({i, frame.toLocal(light.direction), light.normalIlluminance * share});
  }
  node.arrivals = tree.arrivals.size() - node.firstArrival;
}

double TreeBuilder::seen(const scene::LightSource& source, Vec3 origin, const Vec3& target, std::uint64_t& rays) const {
  const Vec3 way = target - origin;
  double length = glm::length(way), share = 1;
  if (!(length > tracer_.slack())) return 1;
  const Vec3 direction = way / length;
  length = length * (1 - 1e-5) - tracer_.slack();
  while (length > 0) {
    ++rays;
    tracer::Hit hit;
    if (!tracer_.intersect(origin, direction, hit) || hit.distance >= length) return share;
    const scene::Surface& surface = world_.surfaces[hit.surface];
    const bool inside = glm::dot(hit.normal, direction) > 0;
    if (std::find(source.housings.begin(), source.housings.end(), surface.object) == source.housings.end()) {
      const reflection::LocalShading& shading = *shadings_[surface.material];
      if (!shading.transmits() || shading.bends()) return 0;
      const core::Frame frame = frameAbout(inside ? -hit.normal : hit.normal);
      std::vector<float> through(count_);
      shading.transmittedFactor(frame.toLocal(-direction), {}, through.data());
      share *= static_cast<double>(through[hero_]);
    }
    const Vec3 next = tracer_.leave(hit.position, inside ? hit.normal : -hit.normal);
    length -= std::max(glm::dot(next - origin, direction), tracer_.slack());
    origin = next;
  }
  return share;
}

Response evaluate(const IntersectionTree& tree, const Shadings& shadings, const TreeLighting& lighting,
                  const scene::World& world) {
  Response result{};
  if (tree.nodes.empty()) return result;
  const std::size_t sources = lighting.weights.size(), count = sources > 0 ? lighting.weights.front().size() : 0;
  const std::size_t block = sources * count;
  thread_local std::vector<float> values, factor, light;
  values.assign(tree.nodes.size() * block, 0.0f);
  factor.resize(count);
  light.resize(count);
  const auto dimming = [&](std::uint32_t emitter) {
    return lighting.dimming.empty() || emitter == scene::none ? 1.0 : lighting.dimming[emitter];
  };
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const TreeNode& node = tree.nodes[i];
    float* own = values.data() + i * block;
    const reflection::LocalShading& shading = *shadings[node.material];
    const reflection::Interface at = interfaceOf(node, count / 2);
    if (node.luminance > 0) {
      const auto l = static_cast<float>(node.luminance * dimming(node.emitter));
      for (std::size_t k = 0; k < count; ++k) own[node.spectrum * count + k] += l;
    }
    for (std::size_t a = node.firstArrival; a < node.firstArrival + node.arrivals; ++a) {
      const Arrival& arrival = tree.arrivals[a];
      const double on = dimming(arrival.emitter);
      if (on == 0) continue;
      std::fill(light.begin(), light.end(), 0.0f);
      shading.addSource(node.out, arrival.in, arrival.e * on, at, light.data());
      float* mine = own + world.emitters[arrival.emitter].spectrum * count;
      for (std::size_t k = 0; k < count; ++k) mine[k] += light[k];
    }
    if (!lighting.ambient.empty() && !node.forLampsOnly) {
      shading.ambientFactor(factor.data());
      for (std::size_t s = 0; s < sources; ++s)
        for (std::size_t k = 0; k < count; ++k)
          own[s * count + k] += factor[k] * static_cast<float>(lighting.ambient[k] * lighting.ambientShare[s]);
    }
    const auto addChild = [&](std::int32_t child, const reflection::Medium* medium, bool through) {
      if (child < 0) return;
      through ? shading.transmittedFactor(node.out, at, factor.data())
              : shading.reflectedFactor(node.out, at, factor.data());
      shading.attenuate({tree.nodes[static_cast<std::size_t>(child)].distance, medium}, factor.data());
      const float* theirs = values.data() + static_cast<std::size_t>(child) * block;
      for (std::size_t s = 0; s < sources; ++s)
        for (std::size_t k = 0; k < count; ++k) own[s * count + k] += factor[k] * theirs[s * count + k];
    };
    addChild(node.reflected, node.here, false);
    addChild(node.transmitted, node.beyond, true);
  }
  for (std::size_t s = 0; s < sources; ++s)
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t c = 0; c < result.size(); ++c)
        result[c] += static_cast<double>(values[s * count + k]) * lighting.weights[s][k][c];
  return result;
}

}  // namespace goniolux::solver
