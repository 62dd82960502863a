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

scene::View smallFirstView(const project::Project& project, int width) {
  scene::View view = project.views.front();
  view.height = std::max(1, view.height * width / view.width);
  view.width = width;
  return view;
}

spectrum::Xyz lightestOf(const image::XyzImage& image) {
  std::vector<std::size_t> order(image.y.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto at = order.begin() + static_cast<std::ptrdiff_t>(order.size() * 98 / 100);
  std::nth_element(order.begin(), at, order.end(),
                   [&](std::size_t a, std::size_t b) { return image.y[a] < image.y[b]; });
  return {static_cast<double>(image.x[*at]), static_cast<double>(image.y[*at]), static_cast<double>(image.z[*at])};
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
