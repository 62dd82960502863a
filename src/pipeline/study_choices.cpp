#include "pipeline/study_choices.h"

#include <algorithm>

namespace goniolux::pipeline {

const std::vector<ChoiceStudy>& choiceStudies() {
  static const std::vector<ChoiceStudy> studies{wavelengthStudy(),  schemeStudy(),       treeDepthStudy(),
                                                nearFieldStudy(),   bounceStudy(),       reflectionModelStudy(),
                                                gridSpacingStudy(), webResolutionStudy()};
  return studies;
}

const ChoiceStudy* findChoiceStudy(const std::string& name) {
  const auto& all = choiceStudies();
  const auto found = std::find_if(all.begin(), all.end(), [&](const ChoiceStudy& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

void addPoint(plot::LineChart& chart, const std::string& curve, double x, double y) {
  auto line = std::find_if(chart.curves.begin(), chart.curves.end(),
                           [&](const plot::ChartCurve& each) { return each.name == curve; });
  if (line == chart.curves.end()) line = chart.curves.insert(line, {curve, {}, true});
  const auto place = std::upper_bound(line->points.begin(), line->points.end(), x,
                                      [](double value, const core::Vec2& point) { return value < point.x; });
  line->points.insert(place, {x, y});
}

void nothingToStudy(const project::Project& project, const std::string& why) {
  throw core::InputError({project.file, 0, 0}, "nothing-to-study", why);
}

}  // namespace goniolux::pipeline
