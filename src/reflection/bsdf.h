// Bsdf: the bidirectional scattering distribution function of a finish at the spectral samples that rays carry.
//
// Local frame of the hit: z is the normal on the side of the viewer. `out` points to the viewer (out.z > 0), `in` to
// where the light comes from: in.z > 0 is reflection, in.z < 0 transmission. Spectral values are arrays of N floats,
// N = SpectralQuadrature::wavelengths.size(). Values are of radiance: light that enters a denser medium gains the
// factor (n_here / n_beyond)^2, which BsdfSample::scale states apart. Immutable, thread safe.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/parameter.h"
#include "core/vector.h"
#include "material/material.h"
#include "spectrum/spectral_quadrature.h"
#include "texture/mixture.h"

namespace goniolux::reflection {

/// The two media that meet at the hit. Finishes that do not transmit do not look at it.
struct Interface {
  const float* indexHere = nullptr;    ///< refractive index on the viewer's side at the nodes; null: 1 everywhere
  const float* indexBeyond = nullptr;  ///< on the other side; null: 1 everywhere
  std::size_t hero = 0;                ///< the node whose index decides where refracted light goes
  const texture::Mixture* mixture = nullptr;  ///< of a textured finish at the hit; null: its mean

  [[nodiscard]] double here(std::size_t k) const { return indexHere ? static_cast<double>(indexHere[k]) : 1.0; }
  [[nodiscard]] double beyond(std::size_t k) const { return indexBeyond ? static_cast<double>(indexBeyond[k]) : 1.0; }
};

/// What fills a closed shape of a transparent finish.
struct Medium {
  std::vector<float> index;        ///< refractive index at the nodes
  std::vector<float> attenuation;  ///< Bouguer's law: transmittance exp(-a d); 1/m at the nodes
  bool absorbs = false;
  bool disperses = false;  ///< the index is not the same at all nodes
};

struct BsdfSample {
  core::Vec3 direction{0, 0, 1};  ///< towards where the light comes from
  bool specular = false;          ///< a single direction: next-event estimation cannot find it
  bool straight = false;          ///< of these, one that goes on without a bend (a thin pane)
  bool dispersed = false;         ///< only the hero's weight holds: light of the other nodes comes from elsewhere
  double density = 0;             ///< per sr; of a single direction the probability of its choice
  double scale = 1;               ///< the part of the weight that is (n_here / n_beyond)^2, no loss of light
};

/// What kinds of directions a finish scatters into.
struct Lobes {
  bool spread = true;      ///< evaluate() is not 0 everywhere
  bool single = false;     ///< sample() may choose single directions
  bool glossy = false;     ///< spread, but narrow: emitters are to be looked for by sample() as well
  bool transmits = false;  ///< light comes through from the other side
  bool straight = false;   ///< of single directions, through without a bend (see straightTransmittance)
  bool mirror = false;     ///< of single directions, the mirror direction (see mirrorReflectance)
  bool angular = false;    ///< the mirror's reflectance is not the same at every angle
};

class Bsdf {
 public:
  explicit Bsdf(Lobes lobes) : lobes_(lobes) {}
  virtual ~Bsdf() = default;

  [[nodiscard]] const Lobes& lobes() const { return lobes_; }
  /// Only single directions (a mirror): evaluate() is 0 everywhere.
  [[nodiscard]] bool isSpecular() const { return !lobes_.spread; }

  /// f in 1/sr for light from `in` seen from `out`, into values[0..N); single directions are not in it.
  virtual void evaluate(const core::Vec3& out, const core::Vec3& in, const Interface& at, float* values) const = 0;
  /// The density per sr with which sample() chooses `in`; single directions are not in it. Its integral over all
  /// directions is at most 1.
  [[nodiscard]] virtual double density(const core::Vec3& out, const core::Vec3& in, const Interface& at) const = 0;
  /// Chooses a direction; weight[0..N) gets f |cos| / density. False: absorbed.
  virtual bool sample(const core::Vec3& out, const core::Vec2& u, const Interface& at, BsdfSample& chosen,
                      float* weight) const = 0;

  /// Reflectance of light that arrives from the mirror direction at this cosine and stays a single direction.
  virtual void mirrorReflectance(double cosine, float* values) const;
  /// Transmittance of light that goes straight through at this cosine.
  virtual void straightTransmittance(double cosine, float* values) const;
  /// The part of the hemispherical reflectance that follows Lambert's law, for solutions of diffuse interreflection.
  virtual void diffuseReflectance(float* values) const;
  /// The same at a hit, of a textured finish.
  virtual void diffuseReflectanceAt(const Interface&, float* values) const { diffuseReflectance(values); }
  /// True when evaluate() is diffuseReflectance() / pi and nothing else happens.
  [[nodiscard]] virtual bool isLambertian() const { return false; }
  /// What fills a closed shape with this finish; null: nothing that light goes through.
  [[nodiscard]] virtual const Medium* medium() const { return nullptr; }
  /// Largest hemispherical reflectance and transmittance together, over the nodes and directions.
  [[nodiscard]] virtual double largestReflectance() const = 0;

 protected:
  [[nodiscard]] virtual std::size_t nodes() const = 0;

 private:
  Lobes lobes_;
};

/// A reflection model of the registry (the paper's branch table): adding one is a file of its own and a line in
/// models.cpp. The tests of tests/reflection hold every entry to what it declares.
struct ReflectionModel {
  std::string name, title;
  /// f(out, in) / n_in^2 = f(in, out) / n_out^2.
  bool reciprocal = true;
  /// What is scattered is at most what arrived, in every direction.
  bool conservesEnergy = true;
  std::vector<core::Parameter> parameters;  ///< kinds: spectrum, refractiveIndex, number
  /// What the parameters must hold together, as a sentence for the user; "" = all is well.
  std::string (*complaint)(const material::Material& material) = nullptr;
  std::unique_ptr<Bsdf> (*make)(const material::Material& material,
                                const spectrum::SpectralQuadrature& quadrature) = nullptr;
};

const std::vector<ReflectionModel>& reflectionModels();
const ReflectionModel* findReflectionModel(const std::string& name);

/// The finish's distribution function: by its model, or of a textured finish the mixture of its components. Its model
/// must be one of the registry.
std::unique_ptr<Bsdf> makeBsdf(const material::Material& material, const spectrum::SpectralQuadrature& quadrature);

}  // namespace goniolux::reflection
