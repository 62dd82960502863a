// LightList: the emitters of a world, and their mirror images in its plane mirrors, as lights that a point can be
// connected to.
//
// A light is an emitter and a sequence of mirror planes that its light meets on the way from the point. The connection
// is sampled in the unfolded space (the point reflected through the planes), then followed along the real ray: each hit
// must be the next mirror. So light that comes by plane mirrors is found by next-event estimation; mirror sequences
// longer than imageDepth() and curved mirrors are left to the paths that hit an emitter by chance. Points and lines
// cannot be hit: between parallel mirrors their images go on until the rest of the row is small, and bounded.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vector.h"
#include "emitter/emitter.h"
#include "scene/world.h"

namespace goniolux::solver {

/// A plane mirror of one finish, of any outline.
struct MirrorPlane {
  core::Vec3 normal{0, 0, 1};
  double offset = 0;  ///< dot(normal, x) = offset on the plane
  std::uint32_t material = scene::none;
  [[nodiscard]] double side(const core::Vec3& x) const { return glm::dot(normal, x) - offset; }
  [[nodiscard]] core::Vec3 reflectPoint(const core::Vec3& x) const { return x - normal * (2 * side(x)); }
  [[nodiscard]] core::Vec3 reflectDirection(const core::Vec3& d) const {
    return d - normal * (2 * glm::dot(normal, d));
  }
};

struct Light {
  const emitter::Emitter* emitter = nullptr;
  std::uint32_t source = 0;  ///< index into World::emitters
  std::uint32_t spectrum = 0;
  std::vector<std::uint32_t>
      mirrors;      ///< planes in the order in which they are met from the point; empty: seen directly
  double rest = 0;  ///< the images that follow in its row bring at most this times its own light
};

/// A receiver as a light sees it: reflected through the light's mirrors.
struct Unfolded {
  core::Vec3 point, normal;
};

class LightList {
 public:
  /// `mirrorReflectance[m]`: the largest over the wavelengths and angles where material m is an ideal mirror, else 0.
  /// The world must outlive the list.
  LightList(const scene::World& world, const std::vector<double>& mirrorReflectance);

  [[nodiscard]] const std::vector<Light>& lights() const { return lights_; }
  [[nodiscard]] const std::vector<MirrorPlane>& planes() const { return planes_; }
  /// The plane of a primitive (Hit::primitive), or scene::none when it is no plane mirror.
  [[nodiscard]] std::uint32_t planeOf(std::uint32_t primitive) const {
    return primitive < planeOfTriangle_.size() ? planeOfTriangle_[primitive] : scene::none;
  }
  /// Longest sequence of plane mirrors that is in the list.
  [[nodiscard]] int imageDepth() const { return imageDepth_; }

  [[nodiscard]] Unfolded unfold(const Light& light, const core::Vec3& point, const core::Vec3& normal) const;
  /// A direction of the unfolded space, as it leaves the real point.
  [[nodiscard]] core::Vec3 fold(const Light& light, core::Vec3 direction) const;

  /// Chooses a light for a point in proportion to its importance there: index and probability; false when no light can
  /// reach it.
  bool choose(const core::Vec3& point, const core::Vec3& normal, double u, std::uint32_t& light,
              double& probability) const;
  struct Choice {
    std::uint32_t light;
    double weight;  ///< with which its light counts, so that all choices together expect all light
  };
  /// At most `count` choices of that kind, spread evenly over the lights (systematic sampling); none when no light can
  /// reach it.
  void chooseMany(const core::Vec3& point, const core::Vec3& normal, double u, std::size_t count,
                  std::vector<Choice>& choices) const;

 private:
  /// Running sum of the lights' importance for a point.
  [[nodiscard]] const std::vector<double>& cumulativeImportance(const core::Vec3& point,
                                                                const core::Vec3& normal) const;
  void findPlanes();
  void addImages();
  void addRows();

  const scene::World& world_;
  std::vector<double> mirrorReflectance_;
  std::vector<MirrorPlane> planes_;
  std::vector<std::uint32_t> planeOfTriangle_;
  std::vector<Light> lights_;
  int imageDepth_ = 0;
};

}  // namespace goniolux::solver
