// Lighting scenes by superposition: light adds up, so the grids are calculated once for each group of luminaires alone,
// at its full level, and every scene is a sum of them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/progress.h"
#include "project/project.h"
#include "project/results.h"

namespace goniolux::pipeline {

/// The group of the surfaces that emit, which no scene dims.
inline constexpr const char* emittingSurfaces = "emitting-surfaces";

/// The project's groups in the order of their first luminaire; at the end emittingSurfaces if there are any.
std::vector<std::string> groupsOf(const project::Project& project);

/// The project with only this group lit, its luminaires at their full level (dimming 1). Without observers and
/// requirements: glare does not add up over groups.
project::Project onlyGroup(const project::Project& project, const std::string& group);

/// Dimming factors of a group's luminaires as the project states them; superposition needs one per group. InputError
/// names a group whose luminaires have different ones.
std::map<std::string, double> dimmingOf(const project::Project& project);

/// What the lamps' spectra do to a key: nothing where results are kept for any lamp (kept_wavelengths.h).
enum class LampSpectra { matter, doNotMatter };

/// Identifies what the groups' results depend on: every input and setting, but no scene and no dimming.
std::string groupKey(const project::Project& project, LampSpectra spectra = LampSpectra::matter);

/// The scene with `level` times the results of each group (a group without a level is off). Statistical half-widths of
/// groups are independent and add in squares, systematic bounds add up. The minimum's half-width is that of its point,
/// U0's and Ud's are the sums of their parts' relative half-widths. InputError when the groups' grids do not match.
project::Results superposed(const std::map<std::string, project::Results>& groups,
                            const std::map<std::string, double>& levels);

}  // namespace goniolux::pipeline
