// Study: one project calculated by every solver and a ladder of settings, each run held against one long unbiased
// reference: what accuracy costs, and whether the intervals hold. Its grids, and its first view as a small picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/document.h"
#include "core/progress.h"
#include "image/xyz_image.h"
#include "pipeline/cross_check.h"
#include "planner/plan.h"
#include "plot/line_chart.h"
#include "project/project.h"
#include "project/results.h"
#include "scene/view.h"
#include "spectrum/colorimetry.h"

namespace goniolux::pipeline {

/// What is varied.
struct StudySetting {
  std::string line;         ///< of the chart that it belongs to: the solver's name, or what is changed
  std::string solver;       ///< by name
  double accuracy = 0;      ///< asked of the grids or the picture, relative; 0.01 = 1 %
  std::string spectral;     ///< "auto" or "SCHEME:N"
  bool ofPicture = false;   ///< of the first view; else of the grids
  std::string change = {};  ///< KEY=NUMBER, one of studyChanges(); "": nothing
  double work = 1;          ///< about how long it takes, over other settings of the same line
};

/// One run against the reference. Errors are relative to the reference's value, or to a tenth of the grid's mean where
/// the value is below that (as accuracy is asked), over all points of all grids; of a picture likewise, over the
/// luminances of its pixels, RMS over the 95 % that are nearest (as accuracy is asked of pictures).
struct StudyRun {
  StudySetting setting;
  bool isAuto = false;  ///< the settings that the planner chose
  bool reached = false;
  double cpu_s = 0, wall_s = 0;
  std::uint64_t rays = 0;
  double rms = 0, largest = 0, mean = 0;  ///< relative
  double inside = 0;                      ///< share of points whose interval holds the reference (its own error added)
  double peakMemory_MiB = 0;              ///< of the process during the run; 0: unknown here
  std::optional<double> delta, deltaP95;  ///< of a picture: CIEDE2000 of its pixels, mean and 95 %
  std::string leftOut = {};               ///< what the run names first as left out; "" = nothing
};

/// The reference of the grids and what is known about it.
struct StudyReference {
  project::Results results;
  double noise = 0;  ///< RMS of its own standard errors, relative
};

/// The reference of the picture: the project's first view, small.
struct StudyPicture {
  scene::View view;
  image::XyzImage image;
  spectrum::Xyz white;  ///< that CIELAB takes as white
  double noise = 0;     ///< RMS of its own standard errors, relative
};

/// Keys of StudySetting::change: "tree.max_depth", "tree.cutoff", "pixel.max_samples" of the settings, and
/// "luminaire.points": n, every luminous opening cut into n x n points.
project::Project changed(project::Project project, const std::string& change);

/// The project with the setting's solver, wavelengths and change, this seed, and at most `seconds`.
project::Project withSetting(const project::Project& project, const StudySetting& setting, std::uint64_t seed,
                             double seconds);

/// The ladder of settings. First what `auto` does, then all methods of a coarse rung before any of a finer one: what is
/// left out for want of time are the finest.
std::vector<StudySetting> studySettings(const project::Project& project, const planner::Plan& plan, bool ofPicture);

/// A run by paths of `seconds`, or the one in `file` if that was made for `key` and is no shorter.
StudyReference makeReference(const project::Project& project, const std::string& key, const std::string& file,
                             double seconds, core::ProgressSink& progress);
StudyPicture makePictureReference(const project::Project& project, const std::string& key, const std::string& file,
                                  double seconds, core::ProgressSink& progress);

/// How far `found` is from the reference; fills the figures of a run.
void compareWithReference(const project::Results& found, const StudyReference& reference, StudyRun& run);

/// Calculates the project's grids by `setting` with its own seed, in at most `seconds`, and fills everything but
/// `isAuto`. `found`: gets the results, if it is there.
StudyRun runSetting(const project::Project& project, const StudySetting& setting, const StudyReference& reference,
                    std::uint64_t seed, double seconds, core::ProgressSink& progress,
                    project::Results* found = nullptr);
/// The same of the picture.
StudyRun runPicture(const project::Project& project, const StudySetting& setting, const StudyPicture& reference,
                    std::uint64_t seed, double seconds, core::ProgressSink& progress);

/// The peak of this process's memory since the last call of forgetPeakMemory(), MiB; 0 where it is unknown.
double peakMemory_MiB();
void forgetPeakMemory();

/// What the work-precision chart of grids or of a picture stands on.
struct StudyChartText {
  std::string project, measured;  ///< "points of the grids", "pixels of the view ..."
  double noise = 0;               ///< of the reference, relative
  std::size_t count = 0;          ///< of points or pixels
};
/// The work-precision chart: RMS error over CPU time, a line per method, both axes logarithmic; the front, the plateaus
/// of biased methods, and what the planner chose.
plot::LineChart workPrecisionChart(const StudyChartText& text, const std::vector<StudyRun>& runs);

/// The runs that no other run beats in both time and error, by rising time.
std::vector<const StudyRun*> paretoFront(const std::vector<StudyRun>& runs);
/// Runs whose intervals do not hold the reference and whose error is mostly the same everywhere or named as left out:
/// no time would help them. The nearest of each line.
std::vector<const StudyRun*> plateaus(const std::vector<StudyRun>& runs);

/// One project's study, kept in a folder.
struct ProjectStudy {
  std::string path, name;
  std::vector<StudyRun> grids, picture;
  std::optional<StudyReference> reference;
  std::optional<StudyPicture> pictureReference;
  std::string chosen, chosenForPicture;  ///< the solvers that the planner takes
  std::size_t leftOut = 0;               ///< finer runs that do not fit into the time
  std::optional<core::Value> cross;      ///< the two independent solvers on the grids: document of cross_check.h
  double spent_s = 0;                    ///< of the time that was given
  std::string trouble;                   ///< of a project of several that cannot be studied
};

/// What a study may spend, and where it stands among several.
struct StudyTime {
  double time_s = 120;
  std::optional<double> reference_s = {};  ///< of references, which then do not count; else a share of the time
  double from = 0, to = 1;                 ///< of the progress of all
};

/// Makes what is not kept in the folder: references first, then the ladders of grids and picture by turns. Warns of
/// references that are coarse. Throws core::InputError where there is nothing to study.
ProjectStudy makeStudy(const project::Project& project, const std::string& lightingScene, const std::string& folder,
                       const StudyTime& time, core::ProgressSink& progress, core::Diagnostics& warnings);

/// The page about several studies, Markdown: what machine it was, a summary with times as ratios, charts and tables for
/// each project. Pictures stand in folders named after the project's path.
std::string studyPage(const std::vector<ProjectStudy>& studies, double time_s);

std::string studyCsv(const ProjectStudy& study);
/// The tables that a terminal shows.
std::string studyText(const ProjectStudy& study);
core::Value toJson(const StudyRun& run);
core::Value toJson(const ProjectStudy& study);
/// Nothing where the line is not one of toJson()'s (a file that was cut off).
std::optional<StudyRun> studyRunFromJson(const core::Value& json);

}  // namespace goniolux::pipeline
