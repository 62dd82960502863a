// The keys of a luminaire that say how its light leaves: "photometry", "flux", "lamp_flux".
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "photometry/intensity_distribution.h"
#include "photometry/photometric_file.h"
#include "project/section_reader.h"

namespace goniolux::project {

struct LuminairePhotometry {
  std::string name;                                   ///< file name or built-in name
  const photometry::PhotometricFile* file = nullptr;  ///< owned by Reading; null for built-in photometry
  /// Null for "diffuse": uniform luminance over the whole opening.
  std::shared_ptr<const photometry::IntensityDistribution> distribution;
  double scale = 1;    ///< multiplies the distribution's candelas
  double flux_lm = 0;  ///< of one luminaire, before maintenance and dimming
};

/// Nothing after an error.
std::optional<LuminairePhotometry> readPhotometry(SectionReader& luminaire, Reading& reading);

}  // namespace goniolux::project
