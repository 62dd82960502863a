#include "solver/light_list.h"

#include <algorithm>
#include <cmath>

namespace goniolux::solver {

using core::Vec3;

namespace {

// More images than this cost more than they save; longer sequences are then left to chance hits.
constexpr std::size_t mostLights = 192;
constexpr int mostMirrors = 8;
// Between two parallel mirrors a row of images grows by two with each reflection.
constexpr std::size_t longestRow = 96, mostRowImages = 1024;
constexpr double smallRest =
    1e-3;  // of the light of the first image of the row, as the inverse square lets it decrease

}  // namespace

LightList::LightList(const scene::World& world, const std::vector<double>& mirrorReflectance)
    : world_(world), mirrorReflectance_(mirrorReflectance) {
  for (std::uint32_t i = 0; i < world.emitters.size(); ++i)
    lights_.push_back({world.emitters[i].emitter.get(), i, world.emitters[i].spectrum, {}});
  findPlanes();
  addImages();
  addRows();
}

void LightList::findPlanes() {
  planeOfTriangle_.assign(world_.triangles.size(), scene::none);
  const double tolerance = 1e-7 * world_.radius;
  for (std::size_t t = 0; t < world_.triangles.size(); ++t) {
    const std::uint32_t material = world_.surfaces[world_.triangleSurfaces[t]].material;
    if (!(mirrorReflectance_[material] > 0)) continue;
    const auto& corner = world_.triangles[t];
    const Vec3 &a = world_.vertices[corner[0]], &b = world_.vertices[corner[1]], &c = world_.vertices[corner[2]];
    const Vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    std::uint32_t found = scene::none;
    for (std::uint32_t p = 0; p < planes_.size() && found == scene::none; ++p) {
      const MirrorPlane& plane = planes_[p];
      const bool inPlane = plane.material == material && std::abs(plane.side(a)) < tolerance &&
                           std::abs(plane.side(b)) < tolerance && std::abs(plane.side(c)) < tolerance;
      if (inPlane && std::abs(glm::dot(plane.normal, normal)) > 1 - 1e-9) found = p;
    }
    if (found == scene::none) {
      if (planes_.size() >= mostLights) continue;  // a finely facetted mirror: chance hits
      planes_.push_back({normal, glm::dot(normal, a), material});
      found = static_cast<std::uint32_t>(planes_.size() - 1);
    }
    planeOfTriangle_[t] = found;
  }
}

// Sequences of increasing length while they stay few: with n planes, n (n - 1)^(k - 1) of length k per emitter.
void LightList::addImages() {
  if (planes_.empty()) return;
  const std::size_t emitters = lights_.size();
  std::vector<std::vector<std::uint32_t>> sequences{{}};
  for (int depth = 1; depth <= mostMirrors; ++depth) {
    std::vector<std::vector<std::uint32_t>> longer;
    for (const auto& sequence : sequences)
      for (std::uint32_t p = 0; p < planes_.size(); ++p) {
        if (!sequence.empty() && sequence.back() == p) continue;
        longer.push_back(sequence);
        longer.back().push_back(p);
      }
    if (longer.empty() || lights_.size() + emitters * longer.size() > std::max(mostLights, 2 * emitters)) break;
    for (const auto& sequence : longer)
      for (std::size_t e = 0; e < emitters; ++e) {
        Light image = lights_[e];
        image.mirrors = sequence;
        lights_.push_back(std::move(image));
      }
    imageDepth_ = depth;
    sequences = std::move(longer);
  }
}

void LightList::addRows() {
  const std::size_t images = lights_.size(), first = static_cast<std::size_t>(imageDepth_);
  if (first < 2) return;
  std::size_t added = 0;
  for (std::size_t i = 0; i < images; ++i) {
    if (lights_[i].mirrors.size() != first || world_.emitters[lights_[i].source].hasGeometry) continue;
    // Only a sequence to and fro between two parallel planes goes on for ever.
    const std::uint32_t last = lights_[i].mirrors[first - 1], other = lights_[i].mirrors[first - 2];
    bool row = std::abs(glm::dot(planes_[last].normal, planes_[other].normal)) > 1 - 1e-9;
    for (std::size_t k = 0; k + 2 < first; ++k) row = row && lights_[i].mirrors[k] == lights_[i].mirrors[k + 2];
    if (!row) continue;
    const double rho =
        std::max(mirrorReflectance_[planes_[last].material], mirrorReflectance_[planes_[other].material]);
    if (!(rho < 1)) continue;
    Light image = lights_[i];
    double share = 1;  // of the first image of the row, at least
    while (image.mirrors.size() < longestRow && added < mostRowImages && share * rho / (1 - rho) > smallRest) {
      const std::size_t depth = image.mirrors.size();
      image.mirrors.push_back(image.mirrors[depth - 2]);
      share *= rho * std::pow(static_cast<double>(depth) / static_cast<double>(depth + 1), 2);
      lights_.push_back(image);
      ++added;
    }
    // Each further image is farther away, and loses by one reflection more.
    lights_[image.mirrors.size() == first ? i : lights_.size() - 1].rest = rho / (1 - rho);
  }
}

Unfolded LightList::unfold(const Light& light, const Vec3& point, const Vec3& normal) const {
  Unfolded u{point, normal};
  for (const std::uint32_t p : light.mirrors) {
    u.point = planes_[p].reflectPoint(u.point);
    u.normal = planes_[p].reflectDirection(u.normal);
  }
  return u;
}

Vec3 LightList::fold(const Light& light, Vec3 direction) const {
  for (auto p = light.mirrors.rbegin(); p != light.mirrors.rend(); ++p)
    direction = planes_[*p].reflectDirection(direction);
  return direction;
}

const std::vector<double>& LightList::cumulativeImportance(const Vec3& point, const Vec3& normal) const {
  thread_local std::vector<double> cumulative;
  cumulative.resize(lights_.size());
  double sum = 0;
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const Light& candidate = lights_[i];
    if (candidate.mirrors.empty()) {
      sum += candidate.emitter->importance(point, normal);
    } else {
      const Unfolded seen = unfold(candidate, point, normal);
      sum += candidate.emitter->importance(seen.point, seen.normal);
    }
    cumulative[i] = sum;
  }
  return cumulative;
}

bool LightList::choose(const Vec3& point, const Vec3& normal, double u, std::uint32_t& light,
                       double& probability) const {
  const std::vector<double>& cumulative = cumulativeImportance(point, normal);
  const double sum = cumulative.empty() ? 0 : cumulative.back();
  if (!(sum > 0)) return false;
  const auto found = std::upper_bound(cumulative.begin(), cumulative.end() - 1, u * sum);
  light = static_cast<std::uint32_t>(found - cumulative.begin());
  probability = (*found - (found == cumulative.begin() ? 0.0 : *(found - 1))) / sum;
  return probability > 0;
}

void LightList::chooseMany(const Vec3& point, const Vec3& normal, double u, std::size_t count,
                           std::vector<Choice>& choices) const {
  choices.clear();
  const std::vector<double>& cumulative = cumulativeImportance(point, normal);
  const double sum = cumulative.empty() ? 0 : cumulative.back();
  if (!(sum > 0)) return;
  const double step = sum / static_cast<double>(count);
  double pick = u * step;
  for (std::uint32_t i = 0; i < cumulative.size(); ++i) {
    const double importance = cumulative[i] - (i == 0 ? 0.0 : cumulative[i - 1]);
    double picks = 0;
    for (; pick < cumulative[i]; pick += step) picks += 1;
    if (picks > 0) choices.push_back({i, picks * step / importance});
  }
}

}  // namespace goniolux::solver
