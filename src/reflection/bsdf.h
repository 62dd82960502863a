// Bsdf: the bidirectional scattering distribution function of a finish at the spectral samples that rays carry.
// Directions are in the local frame of the hit (z = normal on the side of the viewer) and point away from the surface.
// Spectral values are arrays of N floats, N = SpectralQuadrature::wavelengths.size(). Immutable, thread safe.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/parameter.h"
#include "core/vector.h"
#include "material/material.h"
#include "spectrum/spectral_quadrature.h"

namespace goniolux::reflection {

struct BsdfSample {
  core::Vec3 direction;   ///< towards where the light comes from
  bool specular = false;  ///< a single direction: next-event estimation cannot find it
};

class Bsdf {
 public:
  virtual ~Bsdf() = default;
  /// f in 1/sr for light from `in` seen from `out`, into values[0..N); specular parts are not in it.
  virtual void evaluate(const core::Vec3& out, const core::Vec3& in, float* values) const = 0;
  /// Chooses a direction; weight[0..N) gets f |cos| / density. False: absorbed.
  virtual bool sample(const core::Vec3& out, const core::Vec2& u, BsdfSample& chosen, float* weight) const = 0;
  /// Only single directions (a mirror): evaluate() is 0 everywhere.
  [[nodiscard]] virtual bool isSpecular() const { return false; }
  /// Largest hemispherical reflectance over the nodes and directions.
  [[nodiscard]] virtual double largestReflectance() const = 0;
};

/// A reflection model of the registry (the paper's branch table): adding one is a file of its own and a line in
/// models.cpp.
struct ReflectionModel {
  std::string name, title;
  bool reciprocal = true, conservesEnergy = true;
  std::vector<core::Parameter> parameters;  ///< kinds: spectrum, number
  std::unique_ptr<Bsdf> (*make)(const material::Material& material, const spectrum::SpectralQuadrature& quadrature);
};

const std::vector<ReflectionModel>& reflectionModels();
const ReflectionModel* findReflectionModel(const std::string& name);
/// Models of the project format that this version does not have yet.
const std::vector<std::string>& plannedReflectionModels();

}  // namespace goniolux::reflection
