// Local shading: the paper's reflection models, as they stand at a node of an intersection tree. They are no BSDFs: an
// ambient term, sums over light sources, and factors for the intensities of the two child rays. Only the solver `tree`
// uses them. Local frame and spectral values as in bsdf.h.
//
// Source: R. A. Hall and D. P. Greenberg, "A Testbed for Realistic Image Synthesis", IEEE CG&A 3(8), 1983.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "reflection/bsdf.h"

namespace goniolux::reflection {

/// The way that a child ray has gone.
struct Travel {
  double distance = 0;             ///< d_r or d_t, m
  const Medium* medium = nullptr;  ///< that it went through; null: air
};

class LocalShading {
 public:
  virtual ~LocalShading() = default;
  /// Adds the intensity (cd/m2 per unit of the source's spectrum, at each node) that a source causes towards `out`: `e`
  /// lx arrive from `in` at normal incidence. in.z < 0: from behind.
  virtual void addSource(const core::Vec3& out, const core::Vec3& in, double e, const Interface& at,
                         float* values) const = 0;
  /// The factor of the ambient intensity I_a.
  virtual void ambientFactor(float* values) const = 0;
  /// The factors of the intensities of the reflected and the refracted ray, of length 0.
  virtual void reflectedFactor(const core::Vec3& out, const Interface& at, float* values) const = 0;
  virtual void transmittedFactor(const core::Vec3& out, const Interface& at, float* values) const = 0;
  /// What the way of a child ray does to its intensity: by default Bouguer's F^d.
  virtual void attenuate(const Travel& travel, float* values) const;

  [[nodiscard]] virtual bool isLit() const { return true; }        ///< sources matter at all
  [[nodiscard]] virtual bool seesBehind() const { return false; }  ///< sources behind the surface matter
  [[nodiscard]] virtual bool transmits() const { return false; }   ///< has a refracted ray
  [[nodiscard]] virtual bool bends() const { return true; }        ///< the refracted ray obeys Snell's law
  [[nodiscard]] virtual const Medium* medium() const { return nullptr; }

 protected:
  [[nodiscard]] virtual std::size_t nodes() const = 0;
};

/// One of the paper's models. They do not conserve energy, and say so.
struct ShadingModel {
  std::string name, title;
  std::vector<core::Parameter> parameters;
  /// `asPrinted`: the formula taken literally, whatever the material itself says.
  std::unique_ptr<LocalShading> (*make)(const material::Material& material,
                                        const spectrum::SpectralQuadrature& quadrature, bool asPrinted) = nullptr;
};
const std::vector<ShadingModel>& shadingModels();
const ShadingModel* findShadingModel(const std::string& name);

/// The local shading of a BSDF: light sources by its value, the ambient term by its diffuse part, child rays by its
/// single directions.
std::unique_ptr<LocalShading> shadingOf(std::shared_ptr<const Bsdf> bsdf, std::size_t nodes);

/// A finish of any model in the terms of the paper's `model`: what "reflection_model" in the settings makes of it.
material::Material inPaperTerms(const material::Material& material, const std::string& model);

}  // namespace goniolux::reflection
