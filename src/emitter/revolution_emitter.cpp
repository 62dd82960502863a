// A surface of revolution about the aim with a convex profile: frusta that emit on their outer side. An element sends
// L(d) cos = I(d) n.d / A(d), with A the projected area of the whole surface; convex, no part hides another.
#include <algorithm>
#include <cmath>

#include "emitter/opening_emitter.h"

namespace goniolux::emitter {
namespace {

using core::pi;
using core::Vec2;
using core::Vec3;

struct Frustum {
  Vec2 from, to;            // (radius, place along the aim)
  double normalR, normalZ;  // outward
  double slant;
};

class RevolutionEmitter final : public OpeningEmitter {
 public:
  RevolutionEmitter(const Opening& opening, const Vec3& position, const Output& output)
      : OpeningEmitter(position + output.frame.aim * middleOf(opening), reachOf(opening), output),
        position_(position),
        aim_(output.frame.aim) {
    for (std::size_t i = 0; i + 1 < opening.profile.size(); ++i) {
      const Vec2 &a = opening.profile[i], &b = opening.profile[i + 1];
      const double slant = glm::length(b - a);
      frusta_.push_back({a, b, (b.y - a.y) / slant, -(b.x - a.x) / slant, slant});
      area_ += pi * (a.x + b.x) * slant;
    }
    for (std::size_t i = 0; i < projected_.size(); ++i)
      projected_[i] = projectedExactly(-1 + 2 * static_cast<double>(i) / static_cast<double>(projected_.size() - 1));
    setEmittingArea(area_);
  }

  // A frustum by the area that the point may see of it, then a place of its visible arc.
  [[nodiscard]] IncidentLight sample(const Vec3& point, const Vec2& u) const override {
    const Place place = placeOf(point);
    double sum = 0;
    for (const Frustum& f : frusta_) sum += seenArea(f, place);
    if (!(sum > 0)) return {};
    double pick = u.x * sum;
    std::size_t i = 0;
    while (i + 1 < frusta_.size() && pick >= seenArea(frusta_[i], place)) pick -= seenArea(frusta_[i++], place);
    const double chosen = seenArea(frusta_[i], place);
    if (!(chosen > 0)) return {};
    const Element e = element(static_cast<int>(i), {std::min(pick / chosen, 1.0), u.y}, point);
    if (!(e.area > 0)) return {};
    return fromElement(point, e.point, e.normal, chosen / sum / e.area);
  }

 protected:
  [[nodiscard]] double projectedArea(const Vec3& direction) const override {
    const double at =
        (std::clamp(glm::dot(aim_, direction), -1.0, 1.0) + 1) * 0.5 * static_cast<double>(projected_.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), projected_.size() - 2);
    const double t = at - static_cast<double>(low);
    return (1 - t) * projected_[low] + t * projected_[low + 1];
  }
  [[nodiscard]] int patchCount() const override { return static_cast<int>(frusta_.size()); }
  [[nodiscard]] Element element(int patch, const Vec2& uv, const Vec3& point) const override {
    const Frustum& f = frusta_[static_cast<std::size_t>(patch)];
    const Place place = placeOf(point);
    const Arc arc = visible(f, place);
    if (!(arc.half > 0)) return {};
    const double phi = arc.middle + arc.half * (2 * uv.y - 1);
    const Vec2 at = f.from + (f.to - f.from) * uv.x;
    const Vec3 outwards = place.x * std::cos(phi) + place.y * std::sin(phi);
    return {position_ + outwards * at.x + aim_ * at.y, outwards * f.normalR + aim_ * f.normalZ,
            f.slant * at.x * 2 * arc.half};
  }

 private:
  /// A point in the surface's own cylinder coordinates; x points to it from the axis.
  struct Place {
    double r, z;
    Vec3 x, y;
  };
  [[nodiscard]] Place placeOf(const Vec3& point) const {
    const Vec3 d = point - position_;
    Place place{0, glm::dot(d, aim_), {}, {}};
    const Vec3 sideways = d - aim_ * place.z;
    place.r = glm::length(sideways);
    if (place.r > 0) {
      place.x = sideways / place.r;
      place.y = glm::cross(aim_, place.x);
    } else {
      core::perpendiculars(aim_, place.x, place.y);
    }
    return place;
  }

  /// The part of every ring of a frustum that faces the point: azimuths middle - half to middle + half.
  struct Arc {
    double middle, half;
  };
  [[nodiscard]] static Arc visible(const Frustum& f, const Place& p) {
    // n.(P - X) > 0: normalR r cos(phi) > normalR R + normalZ (Z - z), the same for all rings of a frustum.
    const double a = f.normalR * p.r, b = f.normalR * f.from.x + f.normalZ * (f.from.y - p.z);
    if (std::abs(a) <= 1e-12 * (std::abs(b) + f.slant)) return {0, b < 0 ? pi : 0};
    const double c = std::clamp(b / std::abs(a), -1.0, 1.0);
    return {a > 0 ? 0 : pi, std::acos(c)};
  }
  [[nodiscard]] static double seenArea(const Frustum& f, const Place& p) {
    return f.slant * 0.5 * (f.from.x + f.to.x) * 2 * visible(f, p).half;
  }

  [[nodiscard]] double projectedExactly(double cosine) const {
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    double sum = 0;
    for (const Frustum& f : frusta_) {
      const double a = std::abs(f.normalR * sine), b = f.normalZ * cosine;
      double ring = 0;  // integral of max(0, a cos(phi) + b) over phi
      if (b >= a) {
        ring = 2 * pi * b;
      } else if (b > -a) {
        const double half = std::acos(-b / a);
        ring = 2 * (a * std::sin(half) + b * half);
      }
      sum += f.slant * 0.5 * (f.from.x + f.to.x) * ring;
    }
    return sum;
  }

  static double middleOf(const Opening& opening) {
    const auto [low, high] = std::minmax_element(opening.profile.begin(), opening.profile.end(),
                                                 [](const Vec2& a, const Vec2& b) { return a.y < b.y; });
    return 0.5 * (low->y + high->y);
  }
  static double reachOf(const Opening& opening) {
    double reach = 0;
    for (const Vec2& p : opening.profile) reach = std::max(reach, std::hypot(p.x, p.y - middleOf(opening)));
    return reach;
  }

  Vec3 position_, aim_;
  std::vector<Frustum> frusta_;
  double area_ = 0;
  std::array<double, 1025> projected_{};  // by the cosine from the aim, -1 to 1
};

// From axis to axis upwards, with left turns only.
bool turnsLeft(const std::vector<Vec2>& profile) {
  if (profile.front().x != 0 || profile.back().x != 0) return false;
  for (std::size_t i = 0; i + 2 < profile.size(); ++i) {
    const Vec2 a = profile[i + 1] - profile[i], b = profile[i + 2] - profile[i + 1];
    if (a.x * b.y - a.y * b.x < -1e-12 * glm::length(a) * glm::length(b)) return false;
  }
  return profile.front().y < profile.back().y;
}

}  // namespace

std::vector<Vec2> convexProfile(std::vector<Vec2> profile) {
  if (profile.size() < 3) return {};
  if (turnsLeft(profile)) return profile;
  std::reverse(profile.begin(), profile.end());
  if (turnsLeft(profile)) return profile;
  return {};
}

std::unique_ptr<Emitter> makeRevolutionEmitter(const Opening& opening, const Vec3& position, const Output& output) {
  return std::make_unique<RevolutionEmitter>(opening, position, output);
}

}  // namespace goniolux::emitter
