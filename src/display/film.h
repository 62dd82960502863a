// Film: a film recorder, the film that it exposes, and, for a negative, the print that is made of it; projected by a
// lamp. Densities are decadic.
//
// Code values are densities of the recorded film over its base: code = baseCode + density / densityPerCode. For a
// negative they are printing densities, as the print film's layers see them: its exposure then is logH = -density by
// definition, and no model of the negative's dyes is needed. For a reversal film (no print) they are the amounts of its
// dyes. The film on the screen absorbs with base(lambda) + sum of amount_j * dye_j(lambda).
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "display/device_model.h"
#include "spectrum/spectral_distribution.h"

namespace goniolux::display {

struct Film {
  using Spectra = std::array<spectrum::SpectralDistribution, 3>;
  using Curve = std::vector<std::pair<double, double>>;  ///< log10 exposure and density, both ascending

  double densityPerCode = 0.002;
  int baseCode = 95, bits = 10;

  // The recorder and the film in it: which drive of its three colours makes which density.
  Spectra phosphors, filters, sensitivities;  ///< sensitivities: of the layers that red, green, blue light expose
  std::array<Curve, 3> exposed;  ///< densities of the recorded film; of a reversal film they fall: `reversal`
  bool reversal = false;

  // What is projected: the print, or the reversal film itself.
  std::array<Curve, 3> print;  ///< empty for a reversal film
  Spectra dyes;                ///< cyan, magenta, yellow: density of one unit
  spectrum::SpectralDistribution base, lamp;

  [[nodiscard]] double codeCount() const { return static_cast<double>((1 << bits) - 1); }
  /// Density over base of a code value 0..1, and back.
  [[nodiscard]] double density(double code) const { return (code * codeCount() - baseCode) * densityPerCode; }
  [[nodiscard]] double code(double density) const { return (baseCode + density / densityPerCode) / codeCount(); }
};

/// Light of the three dye amounts on the screen, Y = 1 for the clear film of the print's least densities.
core::Vec3 filmLight(const Film& film, const core::Vec3& codes);

/// What the recorder's colours expose: entry [channel][layer] is the integral of phosphor x filter x sensitivity,
/// divided so that each layer's sum over the channels is 1 (columns are channels).
core::Mat3 recorderCrosstalk(const Film& film);

/// Drive of the recorder's three colours, 1 = the exposure that each layer has at its largest code, for code values;
/// negative where crosstalk exposes a layer more than the code asks: the recorder cannot make that colour.
core::Vec3 recorderDrive(const Film& film, const core::Vec3& codes);

/// Light of the film when only one of the recorder's colours is on, at the drive that gives white together with the
/// others: the composite primaries of phosphor, filter, film and lamp (Hall & Greenberg). Columns; white has Y = 1.
core::Mat3 compositePrimaries(const Film& film);

/// The device's model; device values are code values.
std::unique_ptr<DeviceModel> makeFilmModel(const Device& device);

}  // namespace goniolux::display
