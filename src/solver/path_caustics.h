// The path kernel's connections to small luminaires by curved mirrors and through solid glass and water
// (solver/caustics.h). Part of path_kernel.cpp.
#pragma once

#include "solver/path_kernel.h"

namespace goniolux::solver {

namespace {
constexpr double lookShare = 0.03;
}  // namespace

template <int W>
void PathSolver<W>::findCaustics(std::size_t nodes, double accuracy) {
  const auto likeliest = std::max_element(heroProbability_.begin(), heroProbability_.end());
  const auto hero = static_cast<std::size_t>(likeliest - heroProbability_.begin());
  auto caustics = std::make_unique<Caustics>(world_, tracer_, bsdfs_, *lights_, nodes, hero, accuracy);
  leftOut_ = caustics->leftOut();
  if (!caustics->empty()) caustics_ = std::move(caustics);
  const bool invisible = std::any_of(world_.emitters.begin(), world_.emitters.end(),
                                     [](const scene::LightSource& source) { return !source.hasGeometry; });
  if (invisible && lights_->planes().size() > 1)
    leftOut_.push_back("light of point and line luminaires that arrives by more than " +
                       std::to_string(lights_->imageDepth()) + " plane mirrors in a row");
}

template <int W>
template <typename Visit>
void PathSolver<W>::eachCausticAt(const Vec3& point, std::size_t node, double draw, std::uint64_t& rays,
                                  const Visit& visit) const {
  thread_local std::vector<Caustics::Arrival> arrivals;
  caustics_->arrivals(point, node, draw, arrivals, rays);
  for (const Caustics::Arrival& arrival : arrivals) {
    Spectral filter = Spectral::filled(1);
    caustics_->applyFilter(arrival, node, filter.v.data());
    // Where each wavelength goes its own way, this one stands for itself alone.
    if (caustics_->disperses())
      for (std::size_t k = 0; k < static_cast<std::size_t>(W); ++k)
        if (k != node) filter.v[k] = 0;
    visit(arrival, filter);
  }
}

template <int W>
template <typename Visit>
void PathSolver<W>::everyCausticAt(const Vec3& point, double draw, std::uint64_t& rays, const Visit& visit) const {
  const std::size_t nodes = heroProbability_.size();
  if (!caustics_->disperses()) return eachCausticAt(point, nodes / 2, draw, rays, visit);
  for (std::size_t node = 0; node < nodes; ++node) eachCausticAt(point, node, draw, rays, visit);
}

template <int W>
void PathSolver<W>::planCaustics(Plan& plan, const Receiver& receiver, std::uint64_t& rays) const {
  std::vector<Response> byElement(caustics_->elementCount(), Response{});
  everyCausticAt(receiver.point, -1, rays, [&](const Caustics::Arrival& arrival, const Spectral& filter) {
    const double value = arrival.normalIlluminance * receiver.response(arrival.direction);
    if (value <= 0) return;
    const std::uint32_t spectrum = world_.emitters[arrival.source].spectrum;
    add(byElement[arrival.element], spectrum, filter, value);
    // As much as what one beam alone has led to may have been led to by none.
    if (arrival.isLone) add(plan.quadratureBound, spectrum, filter, value);
  });
  for (const Caustics::Source& source : caustics_->sources())
    for (std::size_t c = 0; c < plan.exact.size(); ++c) {
      double sum = 0, squares = 0;
      for (std::uint32_t element = source.first; element < source.first + source.count; ++element) {
        sum += byElement[element][c];
        squares += byElement[element][c] * byElement[element][c];
      }
      plan.exact[c] += sum;
      // What a few elements say about the whole of a source.
      const double n = source.count;
      if (n > 1) plan.quadratureBound[c] += 2 * std::sqrt(std::max(0.0, n * squares - sum * sum) / (n - 1));
    }
}

template <int W>
void PathSolver<W>::addCaustics(Response& sum, const Vertex& at, const Meeting& met, const Vec3& out,
                                const Shading& shading, const Path& path, bool isSeen, core::Sampler& random,
                                std::uint64_t& rays) const {
  // A look costs as much as a whole path; behind the first reflection one in a few is best.
  if (met.bsdf->largestReflectance() <= 0 || (!isSeen && random.next() >= lookShare)) return;
  const double weight = isSeen ? 1 : 1 / lookShare,
               most = isSeen ? std::numeric_limits<double>::infinity() : caustics_->brightest();
  const bool onlyHero = caustics_->disperses();
  const std::size_t node = onlyHero ? path.hero : heroProbability_.size() / 2;
  eachCausticAt(at.point, node, random.next(), rays, [&](const Caustics::Arrival& arrival, Spectral& filter) {
    const double cosine = glm::dot(arrival.direction, at.normal);
    const Vec3 in = shading.frame.toLocal(arrival.direction);
    if (cosine == 0 || (cosine < 0 && !met.bsdf->lobes().transmits)) return;
    if (shading.isTilted && in.z * cosine <= 0) return;
    const double response = shading.isTilted ? std::abs(in.z) * shading.gain : std::abs(cosine);
    Spectral f = Spectral::filled(0);
    met.bsdf->evaluate(out, in, met.interface, f.v.data());
    f *= filter;
    f *= path.throughput;
    const double chance = onlyHero && !path.dispersed ? heroProbability_[path.hero] : 1;
    add(sum, world_.emitters[arrival.source].spectrum, f,
        std::min(arrival.normalIlluminance, most) * response * weight / chance);
  });
}

}  // namespace goniolux::solver
