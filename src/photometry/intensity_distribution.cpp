#include "photometry/intensity_distribution.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "photometry/arc_tangent.h"

namespace goniolux::photometry {
namespace {

using core::degree;
using core::pi;

// Angles of real files are decimal numbers; what rounding may add when they are compared, in degrees.
constexpr double angleTolerance = 1e-6;
// What a direction that is given by rounded components may miss the end of a table by, in degrees.
constexpr double edgeTolerance = 1e-9;

bool isNear(double a, double b) {
  return std::abs(a - b) <= angleTolerance;
}

class IsotropicDistribution final : public IntensityDistribution {
 public:
  explicit IsotropicDistribution(double intensity_cd) : intensity_(intensity_cd) {}
  [[nodiscard]] double intensity(const core::Vec3&) const override { return intensity_; }
  [[nodiscard]] double flux() const override { return 4 * pi * intensity_; }
  [[nodiscard]] double forwardFlux() const override { return 2 * pi * intensity_; }
  [[nodiscard]] double maximumIntensity() const override { return intensity_; }

 private:
  double intensity_;
};

// The measure of an angle in the solid angle: dOmega = sin(gamma) dgamma dC (type C), cos(V) dV dH (A), cos(H) dH dV
// (B).
enum class Measure { uniform, sine, cosine };

// Integrals over [a, b] (radians) of s(t) and of (t - origin) s(t), s being the measure's factor.
struct Moments {
  double zeroth, first;
};
Moments moments(Measure measure, double origin, double a, double b) {
  switch (measure) {
    case Measure::sine: {
      const double zeroth = std::cos(a) - std::cos(b);
      const double first = (a - origin) * std::cos(a) - (b - origin) * std::cos(b) + std::sin(b) - std::sin(a);
      return {zeroth, first};
    }
    case Measure::cosine: {
      const double zeroth = std::sin(b) - std::sin(a);
      const double first = (b - origin) * std::sin(b) - (a - origin) * std::sin(a) + std::cos(b) - std::cos(a);
      return {zeroth, first};
    }
    case Measure::uniform:
      break;
  }
  return {b - a, (b - a) * (0.5 * (a + b) - origin)};
}

// Weights w so that sum w[i] f[i] is the exact integral over [from, to] (degrees) of the linear interpolant of f times
// the measure.
std::vector<double> integrationWeights(const std::vector<double>& degrees, Measure measure, double from, double to) {
  std::vector<double> weights(degrees.size(), 0.0);
  for (std::size_t i = 0; i + 1 < degrees.size(); ++i) {
    const double a = std::max(degrees[i], from), b = std::min(degrees[i + 1], to);
    if (a >= b) continue;
    const double origin = degrees[i] * degree, step = (degrees[i + 1] - degrees[i]) * degree;
    const Moments m = moments(measure, origin, a * degree, b * degree);
    weights[i] += m.zeroth - m.first / step;
    weights[i + 1] += m.first / step;
  }
  return weights;
}

// The horizontal angles that are searched: with the plane at 360 degrees where a file stops before it.
std::vector<double> closedAngles(PhotometryType type, HorizontalSymmetry symmetry, std::vector<double> horizontal) {
  if (type == PhotometryType::c && symmetry == HorizontalSymmetry::none && !isNear(horizontal.back(), 360)) {
    horizontal.push_back(360);
  }
  return horizontal;
}

}  // namespace

std::shared_ptr<const IntensityDistribution> CosinePowerDistribution::isotropic(double intensity_cd) {
  return std::make_shared<IsotropicDistribution>(intensity_cd);
}

double CosinePowerDistribution::intensity(const core::Vec3& local) const {
  if (!(local.z > 0)) return exponent_ == 0 && local.z == 0 ? peak_ : 0;
  if (exponent_ == 1) return peak_ * local.z;
  return peak_ * std::pow(local.z, exponent_);
}

std::optional<HorizontalSymmetry> horizontalSymmetry(PhotometryType type, const std::vector<double>& horizontal) {
  if (horizontal.empty()) return std::nullopt;
  const double first = horizontal.front(), last = horizontal.back();
  if (type != PhotometryType::c) {
    if (horizontal.size() < 2) return std::nullopt;
    if (isNear(first, 0)) return HorizontalSymmetry::lateral;
    return first < 0 ? std::optional(HorizontalSymmetry::none) : std::nullopt;
  }
  if (horizontal.size() == 1) return HorizontalSymmetry::rotational;
  if (isNear(first, 90) && isNear(last, 270)) return HorizontalSymmetry::aboutC90;
  if (!isNear(first, 0)) return std::nullopt;
  if (isNear(last, 90)) return HorizontalSymmetry::quadrant;
  if (isNear(last, 180)) return HorizontalSymmetry::aboutC0;
  if (last > 180 && last <= 360 + angleTolerance) return HorizontalSymmetry::none;
  return std::nullopt;
}

double symmetryCopies(HorizontalSymmetry symmetry) {
  switch (symmetry) {
    case HorizontalSymmetry::quadrant:
      return 4;
    case HorizontalSymmetry::aboutC0:
    case HorizontalSymmetry::aboutC90:
    case HorizontalSymmetry::lateral:
      return 2;
    case HorizontalSymmetry::rotational:
    case HorizontalSymmetry::none:
      break;
  }
  return 1;
}

AngleAxis::AngleAxis(std::vector<double> degrees) : degrees_(std::move(degrees)) {
  if (degrees_.size() < 2) return;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < degrees_.size(); ++i) {
    smallest = std::min(smallest, degrees_[i + 1] - degrees_[i]);
    inverseSteps_.push_back(1 / (degrees_[i + 1] - degrees_[i]));
  }
  // Bins no wider than the smallest step hold at most one angle, so the search ends after one comparison; the limit
  // keeps memory bounded by the table's size.
  const double range = last() - first();
  const double wanted = std::ceil(range / smallest - angleTolerance);
  const auto bins = static_cast<std::size_t>(std::clamp(wanted, 1.0, 8.0 * static_cast<double>(degrees_.size())));
  binsPerDegree_ = static_cast<double>(bins) / range;
  firstInterval_.reserve(bins + 1);
  std::uint32_t interval = 0;
  for (std::size_t bin = 0; bin <= bins; ++bin) {
    const double lower = first() + static_cast<double>(bin) / binsPerDegree_;
    while (interval + 2 < degrees_.size() && degrees_[interval + 1] <= lower) ++interval;
    firstInterval_.push_back(interval);
  }
}

AngleAxis::Place AngleAxis::find(double degrees) const {
  const double offset = degrees - first();
  if (!(offset > 0) || firstInterval_.empty()) return {0, 0.0};
  if (degrees >= last()) return {degrees_.size() - 2, 1.0};
  const std::size_t bin = std::min(static_cast<std::size_t>(offset * binsPerDegree_), firstInterval_.size() - 2);
  std::size_t i = firstInterval_[bin];
  if (const std::size_t end = firstInterval_[bin + 1]; end > i + 8) {  // many angles crowd in this bin
    const auto begin = degrees_.begin();
    i = static_cast<std::size_t>(std::upper_bound(begin + static_cast<std::ptrdiff_t>(i),
                                                  begin + static_cast<std::ptrdiff_t>(end) + 1, degrees) -
                                 begin);
    i = i > 0 ? i - 1 : 0;
  }
  while (i > 0 && degrees < degrees_[i]) --i;  // only where a bin's edge was rounded past an angle
  while (degrees >= degrees_[i + 1]) ++i;
  return {i, (degrees - degrees_[i]) * inverseSteps_[i]};
}

TabulatedDistribution::TabulatedDistribution(PhotometryType type, std::vector<double> horizontal,
                                             std::vector<double> vertical, std::vector<double> candelas)
    : type_(type),
      symmetry_(horizontalSymmetry(type, horizontal).value_or(HorizontalSymmetry::none)),
      stated_(std::move(horizontal)),
      horizontal_(closedAngles(type, symmetry_, stated_)),
      vertical_(std::move(vertical)),
      candelas_(std::move(candelas)) {
  assert(horizontalSymmetry(type_, stated_).has_value());
  assert(vertical_.degrees().size() >= 2);
  assert(candelas_.size() == stated_.size() * vertical_.degrees().size());
  maximum_ = candelas_.empty() ? 0 : *std::max_element(candelas_.begin(), candelas_.end());
  if (horizontal_.degrees().size() > stated_.size()) {
    candelas_.reserve(candelas_.size() + vertical_.degrees().size());
    for (std::size_t v = 0; v < vertical_.degrees().size(); ++v) candelas_.push_back(candelas_[v]);
  }
  constexpr double all = std::numeric_limits<double>::infinity();
  flux_ = integrate(-all, all, -all, all);
  switch (type_) {  // z > 0, see PhotometryType
    case PhotometryType::a:
      forwardFlux_ = integrate(-90, 90, -all, all);
      break;
    case PhotometryType::b:
      forwardFlux_ = integrate(-all, all, -90, 90);
      break;
    case PhotometryType::c:
      forwardFlux_ = integrate(-all, all, -all, 90);
      break;
  }
}

double TabulatedDistribution::integrate(double horizontalFrom, double horizontalTo, double verticalFrom,
                                        double verticalTo) const {
  // The bilinear basis and the solid angle are products over the two angles, so the integral is too.
  const Measure measureH = type_ == PhotometryType::b ? Measure::cosine : Measure::uniform;
  const Measure measureV = type_ == PhotometryType::b   ? Measure::uniform
                           : type_ == PhotometryType::a ? Measure::cosine
                                                        : Measure::sine;
  std::vector<double> weightsH = integrationWeights(horizontal_.degrees(), measureH, horizontalFrom, horizontalTo);
  const std::vector<double> weightsV = integrationWeights(vertical_.degrees(), measureV, verticalFrom, verticalTo);
  if (symmetry_ == HorizontalSymmetry::rotational) weightsH[0] = 2 * pi;
  double sum = 0;
  for (std::size_t h = 0; h < weightsH.size(); ++h) {
    double plane = 0;
    for (std::size_t v = 0; v < weightsV.size(); ++v) plane += weightsV[v] * candelas_[h * weightsV.size() + v];
    sum += weightsH[h] * plane;
  }
  return symmetryCopies(symmetry_) * sum;
}

double TabulatedDistribution::verticalBandFlux(double from, double to) const {
  constexpr double all = std::numeric_limits<double>::infinity();
  return integrate(-all, all, from, to);
}

double TabulatedDistribution::fold(double horizontalDegrees) const {
  if (symmetry_ == HorizontalSymmetry::rotational) return 0;
  double angle = horizontalDegrees;
  if (type_ != PhotometryType::c) return symmetry_ == HorizontalSymmetry::lateral ? std::abs(angle) : angle;
  angle += 360.0 * static_cast<double>(angle < 0);  // the usual range -180..180, without a branch to mispredict
  if (angle < 0 || angle >= 360) angle -= 360 * std::floor(angle / 360);
  switch (symmetry_) {
    case HorizontalSymmetry::aboutC0:
      return angle > 180 ? 360 - angle : angle;
    case HorizontalSymmetry::aboutC90:
      return angle < 90 ? 180 - angle : angle > 270 ? 540 - angle : angle;
    case HorizontalSymmetry::quadrant: {
      const double half = angle > 180 ? 360 - angle : angle;
      return half > 90 ? 180 - half : half;
    }
    default:
      return angle;
  }
}

double TabulatedDistribution::atAngles(double horizontalDegrees, double verticalDegrees) const {
  if (verticalDegrees < vertical_.first() - edgeTolerance || verticalDegrees > vertical_.last() + edgeTolerance)
    return 0;
  const double h = fold(horizontalDegrees);
  if (type_ != PhotometryType::c &&
      (h < horizontal_.first() - edgeTolerance || h > horizontal_.last() + edgeTolerance)) {
    return 0;
  }
  const AngleAxis::Place v = vertical_.find(verticalDegrees);
  const AngleAxis::Place p = horizontal_.find(h);
  const double* low = candelas_.data() + p.index * vertical_.degrees().size() + v.index;
  // In this form both ends come out to the last bit.
  const auto along = [&](const double* plane) { return (1 - v.fraction) * plane[0] + v.fraction * plane[1]; };
  if (p.fraction == 0) return along(low);
  const double a = along(low), b = along(low + vertical_.degrees().size());
  return p.fraction == 1 ? b : a + p.fraction * (b - a);
}

double TabulatedDistribution::intensity(const core::Vec3& local) const {
  constexpr double perRadian = 180 / pi;
  switch (type_) {
    case PhotometryType::a: {
      const double v = arcTangent(local.y, std::sqrt(local.x * local.x + local.z * local.z));
      return atAngles(arcTangent(local.x, local.z) * perRadian, v * perRadian);
    }
    case PhotometryType::b: {
      const double h = arcTangent(local.x, std::sqrt(local.y * local.y + local.z * local.z));
      return atAngles(h * perRadian, arcTangent(local.y, local.z) * perRadian);
    }
    case PhotometryType::c:
      break;
  }
  const double gamma = arcTangent(std::sqrt(local.x * local.x + local.y * local.y), local.z) * perRadian;
  const double c = symmetry_ == HorizontalSymmetry::rotational ? 0 : arcTangent(local.y, local.x) * perRadian;
  return atAngles(c, gamma);
}

}  // namespace goniolux::photometry
