// Studies of single choices: one thing is varied, all else is held, and what it costs or spoils is drawn. A variant is
// a file of its own and a line of the registry (study_choices.cpp); `goniolux study --of NAME PROJECT` runs it.
#pragma once

#include <string>
#include <vector>

#include "core/progress.h"
#include "image/xyz_image.h"
#include "plot/line_chart.h"
#include "project/project.h"
#include "spectrum/colorimetry.h"

namespace goniolux::pipeline {

/// What a study found: the chart, and the numbers behind it.
struct ChoiceResult {
  plot::LineChart chart;
  std::vector<std::string> columns;  ///< names with units, for study CSV files and the table on a terminal
  std::vector<std::vector<std::string>> rows;
};

struct ChoiceStudy {
  std::string name;   ///< as in --of
  std::string title;  ///< what is varied
  std::string help;   ///< what is measured, a sentence
  /// Throws core::InputError where the project has nothing to vary.
  ChoiceResult (*run)(const project::Project& project, core::ProgressSink& progress);
};

const std::vector<ChoiceStudy>& choiceStudies();
/// nullptr when there is none of that name.
const ChoiceStudy* findChoiceStudy(const std::string& name);

ChoiceStudy wavelengthStudy();
ChoiceStudy treeDepthStudy();
ChoiceStudy nearFieldStudy();
ChoiceStudy bounceStudy();
ChoiceStudy reflectionModelStudy();
ChoiceStudy schemeStudy();
ChoiceStudy gridSpacingStudy();
ChoiceStudy webResolutionStudy();

/// The project's first view, `width` pixels wide. The project must have one.
scene::View smallFirstView(const project::Project& project, int width);
/// White of CIELAB for a picture: the luminance that 2 % of its pixels exceed, in that pixel's colour.
spectrum::Xyz lightestOf(const image::XyzImage& image);

/// Adds a point to the chart's curve of that name, which is made where it is missing.
void addPoint(plot::LineChart& chart, const std::string& curve, double x, double y);
/// The error of a study that has nothing to vary: what is missing, what to do.
[[noreturn]] void nothingToStudy(const project::Project& project, const std::string& why);

}  // namespace goniolux::pipeline
