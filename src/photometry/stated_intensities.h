// Intensities that a file states one by one, in any order, as a table.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "photometry/candela_table.h"

namespace goniolux::photometry {

struct StatedIntensity {
  double h, v, value;
  core::SourcePosition at;
};

/// Refuses an empty list, values below 0, and lists that do not fill a table: every horizontal with every vertical
/// angle, once. `at`: where the list begins.
CandelaTable tableOfIntensities(std::vector<StatedIntensity> list, const core::SourcePosition& at);

/// The angles tell the symmetry, as in LM-63. A list of few planes that is stated to have none ("Symm_None") is closed;
/// any other contradiction to `stated` is a warning. Photometry type C.
void closeBySymmetry(CandelaTable& table, std::string stated, core::Diagnostics& warnings);

}  // namespace goniolux::photometry
