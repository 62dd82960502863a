// Study: one project calculated by every solver and several accuracies, each run held against one long unbiased
// reference: what accuracy costs, and whether the intervals hold.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/document.h"
#include "core/progress.h"
#include "plot/line_chart.h"
#include "project/project.h"
#include "project/results.h"

namespace goniolux::pipeline {

/// What is varied.
struct StudySetting {
  std::string line;      ///< of the chart that it belongs to: the solver's name, or "wavelengths"
  std::string solver;    ///< by name
  double accuracy = 0;   ///< asked of the grids, relative; 0.01 = 1 %
  std::string spectral;  ///< "auto" or "SCHEME:N"
};

/// One run against the reference. Errors are relative to the reference's value, or to a tenth of the grid's mean where
/// the value is below that (as accuracy is asked), over all points of all grids.
struct StudyRun {
  StudySetting setting;
  bool isAuto = false;  ///< the settings that the planner chose
  bool reached = false;
  double cpu_s = 0, wall_s = 0;
  std::uint64_t rays = 0;
  double rms = 0, largest = 0, mean = 0;  ///< relative
  double inside = 0;                      ///< share of points whose interval holds the reference (its own error added)
  double peakMemory_MiB = 0;              ///< of the process during the run; 0: unknown here
};

/// The reference and what is known about it.
struct StudyReference {
  project::Results results;
  double noise = 0;  ///< RMS of its own standard errors, relative
};

/// How far `found` is from the reference; fills the figures of a run.
void compareWithReference(const project::Results& found, const StudyReference& reference, StudyRun& run);

/// Calculates the project by `setting` with its own seed and fills everything but `isAuto`.
StudyRun runSetting(const project::Project& project, const StudySetting& setting, const StudyReference& reference,
                    std::uint64_t seed, core::ProgressSink& progress);

/// The work-precision chart: RMS error over CPU time, a line per method, both axes logarithmic.
plot::LineChart workPrecisionChart(const std::string& project, const std::vector<StudyRun>& runs,
                                   const StudyReference& reference);

/// The runs that no other run beats in both time and error, by rising time.
std::vector<const StudyRun*> paretoFront(const std::vector<StudyRun>& runs);

/// One project's part of a page about several.
struct StudyPageEntry {
  std::string path, name, folder;  ///< folder: of its pictures, as seen from the page
  std::string trouble;
  std::string chosen;  ///< the solver that the planner takes
  const std::vector<StudyRun>* runs = nullptr;
  double noise = 0;
  std::size_t leftOut = 0;
};
/// The page, Markdown: what machine it was, a summary with times as ratios, a chart and a table for each project.
std::string studyPage(const std::vector<StudyPageEntry>& entries, double time_s);

std::string studyCsv(const std::vector<StudyRun>& runs);
core::Value toJson(const StudyRun& run);
/// Nothing where the line is not one of toJson()'s (a file that was cut off).
std::optional<StudyRun> studyRunFromJson(const core::Value& json);

}  // namespace goniolux::pipeline
