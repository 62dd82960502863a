// PhotometricFile: what a photometric file (LM-63, EULUMDAT, TM-33) says about a luminaire, after reading. Lengths in
// metres.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostics.h"
#include "photometry/intensity_distribution.h"
#include "spectrum/spectral_distribution.h"

namespace goniolux::photometry {

/// The luminous opening that the file states, by its extents along its length, across it and along the aim. Flat shapes
/// have one extent of 0, along their axis. A disc, cylinder or sphere of unequal extents is elliptical.
struct StatedOpening {
  enum class Shape { point, line, rectangle, disc, box, cylinder, sphere, other };
  /// Where the normal of a flat shape, or the axis of a cylinder, points.
  enum class Axis { aim, lengthwise, widthwise };
  Shape shape = Shape::point;
  Axis axis = Axis::aim;
  double length = 0, width = 0, height = 0;  ///< m
  bool lengthAlongC90 = false;               ///< EULUMDAT: length along C90; LM-63: along C0
  std::string note;                          ///< for `other`: what the file says
};

/// LM-63's table of lamp output against tilt. The distribution has the factor of 0 degrees (usually 1) applied; a
/// project applies that of the luminaire's own tilt.
struct TiltTable {
  int lampToLuminaireGeometry =
      1;                       ///< 1 lamp base up or down, 2 horizontal, turning with the tilt, 3 horizontal, across it
  std::vector<double> angles;  ///< degrees
  std::vector<double> factors;
};

/// The factor at a tilt in degrees from the position of the measurement, linear between the stated angles, held beyond.
double tiltFactor(const TiltTable& tilt, double degrees);

struct PhotometricFile {
  std::string file;
  std::string format;                                         ///< "LM-63-2002", "EULUMDAT", …
  std::shared_ptr<const TabulatedDistribution> distribution;  ///< multiplier and ballast factors applied
  std::string symmetry;                  ///< "rotational", "quadrant", "C0-C180", "C90-C270", "none"
  bool absolute = false;                 ///< no lamp lumens: candelas are those of the luminaire
  std::optional<double> declaredLumens;  ///< lamp lumens x lamps (relative photometry); none when absolute
  /// Luminous flux of the luminaire as the file states it (EULUMDAT: lamp flux x light output ratio; LM-63: a keyword).
  std::optional<double> declaredLuminaireLumens;
  std::optional<double> lightOutputRatio;  ///< as stated (EULUMDAT), 1 = all
  std::optional<double> downwardFraction;  ///< as stated (EULUMDAT), 0..1
  double inputWatts = 0;                   ///< 0 = not stated
  StatedOpening opening;
  std::map<std::string, std::string> keywords;  ///< MANUFAC, LUMCAT, …
  std::optional<TiltTable> tilt;
  bool radiometric = false;  ///< the file's values are no candelas: nothing is converted, and the units are these:
  std::string intensityUnit = "cd", fluxUnit = "lm";
  std::optional<spectrum::SpectralDistribution> spectrum;  ///< relative spectral power, where the file carries it
  core::Diagnostics warnings;
};

/// Reads one file's bytes. Throws core::InputError with line and column when the file cannot be understood.
using PhotometryReader = PhotometricFile (*)(std::string_view bytes, const std::string& fileName);

/// A format of the registry: adding one is a file of its own and a line in formats.cpp.
struct PhotometryFormat {
  std::string name, title;
  std::vector<std::string> extensions;         ///< lower case, with the dot
  bool (*recognises)(std::string_view bytes);  ///< by content; the extension is only a hint
  PhotometryReader read;
};
const std::vector<PhotometryFormat>& photometryFormats();

/// Lenient: what is unambiguous is read, and every assumption is a warning. Strict: a departure from the format is
/// refused (rules.h), with the whole list of them.
enum class Strictness { lenient, strict };

/// Reads bytes of any registered format; the content decides, then the extension of `fileName`.
PhotometricFile readPhotometry(std::string_view bytes, const std::string& fileName,
                               Strictness strictness = Strictness::lenient);

/// Reads a photometric file of any registered format.
PhotometricFile readPhotometricFile(const std::string& path, Strictness strictness = Strictness::lenient);

}  // namespace goniolux::photometry
