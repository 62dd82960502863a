#include "pipeline/polar.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

/// One closed plane: C on the right, C + 180 degrees on the left.
plot::PolarCurve curveOf(const photometry::IntensityDistribution& distribution, double cDegrees,
                         const std::string& name) {
  plot::PolarCurve curve{name, {}};
  const core::Vec3 across(std::cos(cDegrees * core::degree), std::sin(cDegrees * core::degree), 0);
  for (int half = -360; half <= 360; ++half) {  // half degrees
    const double angle = 0.5 * half;
    const core::Vec3 direction =
        std::sin(angle * core::degree) * across + std::cos(angle * core::degree) * core::Vec3(0, 0, 1);
    curve.points.emplace_back(angle, std::max(0.0, distribution.intensity(direction)));
  }
  return curve;
}

}  // namespace

plot::PolarDiagram polarDiagramOf(const photometry::PhotometricFile& file) {
  plot::PolarDiagram diagram;
  const auto keyword = [&](const char* key) {
    const auto found = file.keywords.find(key);
    return found == file.keywords.end() ? std::string() : found->second;
  };
  diagram.title = keyword("LUMINAIRE");
  if (diagram.title.empty()) diagram.title = fs::path(file.file).filename().string();
  diagram.subtitle = "Luminous intensity in two planes";
  for (const char* key : {"MANUFAC", "LUMCAT"}) {
    if (!keyword(key).empty()) diagram.subtitle += ", " + keyword(key);
  }
  diagram.facts = {fmt::format("flux {:.0f} lm", file.distribution->flux()),
                   fmt::format("highest {:.0f} cd", file.distribution->maximumIntensity())};
  if (file.inputWatts > 0) {
    diagram.facts.push_back(fmt::format("{:g} W", file.inputWatts));
    diagram.facts.push_back(fmt::format("{:.0f} lm/W", file.distribution->flux() / file.inputWatts));
  }
  diagram.footer = fmt::format("goniolux · {} · {}", file.format, fs::path(file.file).filename().string());
  diagram.unit = file.intensityUnit;
  const bool rotational = file.symmetry == "rotational";
  diagram.curves.push_back(curveOf(*file.distribution, 0, rotational ? "all C planes" : "C0 (right) – C180"));
  if (!rotational) diagram.curves.push_back(curveOf(*file.distribution, 90, "C90 (right) – C270"));
  return diagram;
}

}  // namespace goniolux::pipeline
