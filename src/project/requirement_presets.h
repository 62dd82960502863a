// Requirement presets: limits of standards by name, from data/requirements/*.json, each with the clause that it stands
// in. The data state facts of the standards; the standards themselves govern.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/grid.h"

namespace goniolux::project {

/// One entry of a standard's table. Illuminances in lx.
struct RequirementPreset {
  std::string name;      ///< as a project writes it: "en-12464-1:34.2"
  std::string standard;  ///< "EN 12464-1:2021"
  std::string clause;    ///< "table 34, 34.2"
  std::string title;
  std::optional<double> mean, minimum, u0, ud, ugr, ra;
  std::optional<double> cylindrical, wall, ceiling;  ///< means, with a uniformity of 0.10
  bool hasSurrounding = false;                       ///< EN 12464-1: surrounding and background follow from the task's

  std::string comparedWith;  ///< a public page on which the figures are the same; "" = compared with nothing

  /// The clause, as it stands beside a verdict; says so where nothing public confirms the figures.
  [[nodiscard]] std::string reference() const {
    return standard + ", " + clause + (comparedWith.empty() ? " (figures unconfirmed)" : "");
  }
};

const std::vector<RequirementPreset>& requirementPresets();
const RequirementPreset* findRequirementPreset(const std::string& name);
std::vector<std::string> requirementPresetNames();

/// The areas that a preset's limits may be asked for: "task" (the default), "surrounding", "background", "cylindrical",
/// "wall", "ceiling".
const std::vector<std::string>& requirementAreas();

/// The limits of a preset for an area; empty when the standard states none there.
/// EN 12464-1, 5.3: the surrounding area (0.5 m around the task) has the next lower step of the scale, not below that
/// of 150 lx tasks, with U0 0.40; the background area a third of the surrounding's, with U0 0.10.
std::vector<analysis::Limit> presetLimits(const RequirementPreset& preset, const std::string& area);

/// The largest spacing of grid points after EN 12464-1: p = 0.2 · 5^(log10 d), at most 10 m; `d` in metres.
double en12464Spacing(double d);
/// Points along both edges of a rectangle after EN 12464-1: d is its longer edge, or the shorter one where the longer
/// is twice as long or more; the nearest whole number of spacings along it, and as near to that spacing as can be along
/// the other.
std::array<int, 2> en12464Counts(double length, double width);

}  // namespace goniolux::project
