// SpectrumTable: the rows of a spectrum file with the place where each stands, before anything is checked but the
// syntax.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostics.h"

namespace goniolux::spectrum {

struct SpectrumRow {
  double wavelength, value;
  core::SourcePosition wavelengthAt, valueAt;
};

struct SpectrumTable {
  std::vector<SpectrumRow> rows;
  std::string quantity;  ///< what the file itself says its values are ("reflectance"); "" when it does not say
  core::SourcePosition quantityAt;
};

/// Text of two columns, see spectrum_files.h. Faults go to `diagnostics`.
SpectrumTable parseTwoColumns(const std::string& text, const std::string& name, core::Diagnostics& diagnostics);
/// IES TM-27-14 (XML): the SpectralData elements of the first SpectralDistribution. Faults go to `diagnostics`.
SpectrumTable parseTm27(const std::string& text, const std::string& name, core::Diagnostics& diagnostics);

}  // namespace goniolux::spectrum
