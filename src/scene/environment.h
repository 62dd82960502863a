// Environment: everything that light meets, as the project states it: validated once, then read-only. Metres, world
// frame.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "core/vector.h"
#include "emitter/opening.h"
#include "geometry/shape.h"
#include "material/material.h"
#include "photometry/intensity_distribution.h"
#include "spectrum/spectral_distribution.h"
#include "texture/texture.h"

namespace goniolux::scene {

struct Object {
  std::string name;
  geometry::Shape shape;
  core::Mat4 transform{1.0};             ///< object -> world
  std::vector<std::uint32_t> materials;  ///< per part: index into Environment::materials
  bool facesInward = false;              ///< a room: its inside is where people are
  core::SourcePosition position;
  std::vector<core::Mat4> copies = {};  ///< object -> world of further places of the same shape: a large array
};

/// Every place where the object stands: its transform, then its copies.
std::vector<core::Mat4> placesOf(const Object& object);

/// One luminaire (each element of an array is one).
struct Luminaire {
  std::string name;        ///< "L" or "L[i,j]"
  std::string type;        ///< the project's luminaire entry that it came from
  std::string photometry;  ///< file name or built-in name, for tables and provenance
  std::string group;
  core::Vec3 center{0, 0, 0};
  photometry::LuminaireFrame frame;
  emitter::Opening opening;
  /// Null for "diffuse" (uniform luminance over the whole opening).
  std::shared_ptr<const photometry::IntensityDistribution> distribution;
  double scale = 1;    ///< multiplies the distribution's candelas so that `flux_lm` leaves the luminaire
  double flux_lm = 0;  ///< before maintenance and dimming
  double maintenance = 1, dimming = 1;
  double watts = 0;            ///< 0 = not stated
  double reflectance = 0;      ///< of the opening's geometry
  std::uint32_t spectrum = 0;  ///< index into Environment::sourceSpectra
  core::SourcePosition position;
};

struct Environment {
  std::vector<material::Material> materials;
  std::vector<std::shared_ptr<const texture::Texture>> textures;  ///< by Material::texture
  std::vector<std::shared_ptr<const texture::Relief>> reliefs;    ///< by Material::relief
  std::vector<Object> objects;
  std::vector<Luminaire> luminaires;
  std::vector<spectrum::SpectralDistribution> sourceSpectra;  ///< distinct relative spectra of luminaires
};

/// The material for which an object that is not closed has no inside: solid glass or water (a pane has a thickness of
/// its own). Null where there is none.
const material::Material* openGlassOf(const Environment& environment, const Object& object);

}  // namespace goniolux::scene
