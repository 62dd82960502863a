// Results: what `illuminate` found, as it is kept in the results folder: grids.json (everything) and one CSV per grid.
//
// The file says how it was made: project and its hash, program version, seed, settings used, what was left out. World
// frame of the project, metres; illuminances in lx, ratings as numbers; every quantity carries the half-width of its
// confidence interval. Plain values, no shared state.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/document.h"
#include "core/estimate.h"
#include "core/vector.h"

namespace goniolux::project {

struct InputFile {
  std::string path;  ///< as written in the project
  std::string sha256;
};

/// The edges of a regular grid: its corner and the full edges along which the points run.
struct GridPlane {
  core::Vec3 origin{0}, u{0}, v{0};
};

struct GridResult {
  std::string name;
  std::string quantity = "illuminance", unit = "lx";
  std::optional<std::array<int, 2>> counts;  ///< regular grid: along u, along v; values run u fastest
  std::optional<GridPlane> plane;            ///< regular grid only
  std::vector<core::Vec3> points;            ///< m, where the values hold
  std::vector<double> values;                ///< one per point; NaN where excluded
  std::vector<double> halfWidths;            ///< total half-width, one per point; NaN where excluded
  std::map<std::string, std::vector<double>>
      parts;                                    ///< half-widths by cause: "statistical", "truncation", "spectral", …
  std::vector<std::size_t> excluded;            ///< points inside solids, ascending; not counted in the figures below
  core::Estimate mean, min, max;                ///< in `unit`
  core::Estimate u0, ud;                        ///< min/mean and min/max
  std::map<int, core::Estimate> percentiles{};  ///< by percent: that share of the points has no more
  std::optional<core::Estimate> utilance{};     ///< flux on the plane over the flux that leaves the sources
  std::optional<core::Estimate> powerPer100lx{};  ///< W/m2 for 100 lx of the mean
  std::vector<double> initialValues;              ///< the same points with maintenance 1; empty when not calculated
  std::optional<core::Estimate> initialMean;

  /// Value and half-width of one point; what is not statistical stands together under "all".
  [[nodiscard]] core::Estimate pointEstimate(std::size_t index) const;
};

/// A luminaire that an observer sees, as the glare rating counts it.
struct GlareSourceResult {
  std::string luminaire;
  double luminance = 0;   ///< cd/m2, mean of the luminous part that is seen
  double solidAngle = 0;  ///< sr
  double positionIndex = 1;
  double share = 0;  ///< of the glare sum, 0 to 1
};

struct ObserverResult {
  std::string name, quantity = "ugr";
  core::Estimate value;
  core::Vec3 eye{0}, direction{1, 0, 0};     ///< project frame
  core::Estimate background{};               ///< luminance, cd/m2
  std::vector<GlareSourceResult> sources{};  ///< the largest share first
};

/// What light the installation gives and what load it needs for it.
struct LightingPower {
  double flux_lm = 0;                     ///< that leaves all sources as they are lit: maintained, dimmed
  std::optional<double> connectedLoad_W;  ///< of all luminaires undimmed; nothing where one does not state its own
  std::optional<double> floorArea_m2;
  std::optional<core::Estimate> density_W_m2;  ///< connected load over floor area (LPD)
};

struct RequirementResult {
  enum class Verdict { pass, fail, undecided };
  std::string text;
  Verdict verdict = Verdict::undecided;
  std::string of{}, quantity{};  ///< grid or observer, and the limit's key: "mean_lx", "u0", "ugr", …; "": not stated
  std::optional<double> minimum{}, maximum{};
  std::optional<core::Estimate> found{};
  std::string clause{};  ///< where the limit stands in a standard; "" = the project's own
};

/// "pass", "fail" or "undecided".
const char* wordFor(RequirementResult::Verdict verdict);

struct Results {
  std::string project;      ///< the project's name
  std::string projectHash;  ///< project::Project::hash of what was calculated
  std::string programVersion;
  std::string lightingScene;  ///< "" = all groups at their own dimming
  double confidence = 0.95;
  std::uint64_t seed = 1;
  core::Value settingsUsed;          ///< an object, e.g. {"solver": "path", "spectral_samples": 1}
  std::vector<std::string> leftOut;  ///< sentences
  double wallTime_s = 0, cpuTime_s = 0;
  std::uint64_t rays = 0;
  bool reached = true;      ///< the accuracy asked for was met (false: ended by the time limit or interrupted)
  std::string reachedText;  ///< what was reached, in words; "" = nothing to add
  std::vector<GridResult> grids;
  std::vector<ObserverResult> observers;
  std::vector<RequirementResult> requirements;
  std::optional<LightingPower> power;
  std::vector<InputFile> inputs;  ///< every file that was read, the project file first
};

/// The document of `illuminate --json`, which is grids.json too (format "goniolux-results", version 1).
core::Value toJson(const Results& results);

/// Reads and checks that document. Throws core::InputError listing everything that is wrong, with positions: a damaged
/// file is refused, never half believed. Members that this version does not know are passed over.
Results resultsFromJson(const core::Value& document);

/// Reads RESULTS: a folder that holds grids.json, or such a file itself. Throws core::InputError.
Results readResults(const std::string& path);

/// A number of a table: six significant digits (the uncertainty of a value is never below its fourth), empty where
/// there is none.
std::string tableNumber(double value);

/// CSV of one grid: "#" lines saying how it was made, a header line with units, one row per point in the order of the
/// grid: x_m, y_m, z_m, value, half-width (empty where excluded).
std::string toCsv(const Results& results, const GridResult& grid);

/// File name (without extension) made from a name in a project: lower case; everything but letters, digits, '.' and '-'
/// becomes '-' ("work plane" -> "work-plane"). Letters beyond ASCII stay as they are.
std::string fileNameFor(const std::string& name);

/// The name of the results document in its folder.
inline constexpr const char* resultsFileName = "grids.json";

}  // namespace goniolux::project
