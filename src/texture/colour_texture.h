// ColourTexture: a picture's colours as mixtures of a few smooth spectral reflectances.
//
// The reflectances stand at the nodes of a lattice in linear sRGB; a colour between them is their trilinear mixture.
// Tristimulus values are linear in the reflectance and a trilinear rule reproduces what is linear, so that the mixture
// has exactly the picture's colour under D65, lies between 0 and 1 as its parts do, and is smooth as they are (Burns'
// smoothest reflectance at each node, spectrum/smooth_reflectance.h). Under other lamps it is one of many metamers: how
// far measured finishes with the same colour are from it is measured in tests/texture.
#pragma once

#include <memory>
#include <vector>

#include "spectrum/spectral_distribution.h"
#include "texture/picture.h"
#include "texture/texture.h"

namespace goniolux::texture {

class ColourTexture final : public Texture {
 public:
  /// `scale` multiplies the picture's linear values before they are cut off at 1.
  ColourTexture(const Projection& projection, std::shared_ptr<const Picture> picture, double scale);

  /// Of the components, in their order: only nodes that the picture uses are made.
  [[nodiscard]] const std::vector<spectrum::SpectralDistribution>& reflectances() const { return reflectances_; }
  [[nodiscard]] std::vector<double> meanShares() const override { return meanShares_; }
  /// Share of the picture's pixels that were cut off at 1 in some channel.
  [[nodiscard]] double shareCutOff() const { return cutOff_; }

 protected:
  [[nodiscard]] Mixture mix(const Place& place) const override { return mixtureOf(picture_->at(place.flat)); }

 private:
  [[nodiscard]] Mixture mixtureOf(const std::array<double, 3>& linear) const;

  std::shared_ptr<const Picture> picture_;
  double scale_;
  std::vector<std::uint32_t> componentOfNode_;
  std::vector<spectrum::SpectralDistribution> reflectances_;
  std::vector<double> meanShares_;
  double cutOff_ = 0;
};

/// The reflectance of linear sRGB values 0..1 as such a mixture gives it.
spectrum::SpectralDistribution mixedReflectance(const std::array<double, 3>& linear);

}  // namespace goniolux::texture
