#include "pipeline/luminaire_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/document.h"
#include "emitter/near_field.h"
#include "photometry/metrics.h"
#include "pipeline/plot.h"
#include "pipeline/polar.h"
#include "project/opening_reader.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using photometry::HorizontalSymmetry;
using photometry::PhotometricFile;

// Title, facts and footer are those of the polar diagram.
template <typename Figure>
Figure headed(const PhotometricFile& file, const std::string& subtitle) {
  const plot::PolarDiagram polar = polarDiagramOf(file);
  Figure figure;
  figure.title = polar.title;
  figure.subtitle = subtitle;
  figure.facts = polar.facts;
  figure.footer = polar.footer;
  return figure;
}

double intensityAt(const PhotometricFile& file, double c, double gamma) {
  const double g = gamma * core::degree, angle = c * core::degree;
  return std::max(
      0.0, file.distribution->intensity({std::sin(g) * std::cos(angle), std::sin(g) * std::sin(angle), std::cos(g)}));
}

std::vector<double> distinctPlanes(const PhotometricFile& file) {
  switch (file.distribution->symmetry()) {
    case HorizontalSymmetry::rotational:
      return {0};
    case HorizontalSymmetry::quadrant:
      return {0, 45, 90};
    case HorizontalSymmetry::aboutC0:
      return {0, 90, 180};
    case HorizontalSymmetry::aboutC90:
      return {0, 90, 270};
    default:
      return {0, 90, 180, 270};
  }
}

}  // namespace

plot::LineChart cartesianDiagramOf(const PhotometricFile& file) {
  auto chart = headed<plot::LineChart>(file, "Luminous intensity over gamma");
  chart.x.title = "gamma / degrees";
  chart.y.title = "intensity / " + file.intensityUnit;
  const double flux = file.distribution->flux();
  const bool upwards = flux > 0 && file.distribution->forwardFlux() < 0.999 * flux;
  const std::vector<double> planes = distinctPlanes(file);
  for (const double c : planes) {
    plot::ChartCurve curve{planes.size() == 1 ? "all C planes" : fmt::format("C{:g}", c), {}};
    for (int half = 0; half <= (upwards ? 360 : 180); ++half)
      curve.points.emplace_back(0.5 * half, intensityAt(file, c, 0.5 * half));
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

plot::PhotometricSolid photometricSolidOf(const PhotometricFile& file) {
  auto solid = headed<plot::PhotometricSolid>(file, "Photometric solid");
  solid.unit = file.intensityUnit;
  constexpr double planeStep = 3, gammaStep = 2;
  // The direction of the largest intensity and its mirror images are among them, so that the solid is as long as it is.
  const photometry::IntensityPeak peak = photometry::intensityPeak(*file.distribution);
  const double highest = std::fmod(peak.c, 360);
  std::set<double> planes{highest, std::fmod(360 - highest, 360), std::fmod(540 - highest, 360),
                          std::fmod(180 + highest, 360)},
      gammas{peak.gamma};
  for (double each = 0; each <= 360; each += planeStep) planes.insert(each);
  for (double each = 0; each <= 180; each += gammaStep) gammas.insert(each);
  solid.planes.assign(planes.begin(), planes.end());
  solid.gammas.assign(gammas.begin(), gammas.end());
  for (const double c : solid.planes)
    for (const double gamma : solid.gammas) solid.values.push_back(intensityAt(file, c, gamma));
  return solid;
}

plot::LineChart nearFieldChartOf(const PhotometricFile& file) {
  const emitter::Opening opening = project::openingOf(file.opening);
  emitter::Output output;
  output.distribution = file.distribution;
  const double size = emitter::largestExtent(opening);
  if (!(size > 0)) {
    throw core::InputError({file.file, 0, 0}, "no-opening",
                           "the file states no luminous opening: there is no near field to draw");
  }
  auto chart = headed<plot::LineChart>(file, "Error of the illuminance along the aim, opening taken as points");
  chart.x = {"distance / largest extent of the opening", true};
  chart.y = {"error / %", true};
  constexpr double least = 0.01;
  chart.guides = {1};
  for (const int n : {1, 2, 4}) {
    plot::ChartCurve curve{n == 1 ? "one point" : fmt::format("{0} x {0} points", n), {}};
    for (int i = 0; i <= 40; ++i) {
      const double q = 0.2 * std::pow(100, i / 40.0);
      const auto error = emitter::cutError(opening, output, q * size, n);
      if (!error) {
        throw core::InputError({file.file, 0, 0}, "no-light-along-the-aim",
                               "the file sends no light along its aim; the rule is drawn along it");
      }
      curve.points.emplace_back(q, std::max(least, 100 * std::abs(*error)));
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.facts = {fmt::format("largest extent {:g} m", size)};
  if (const auto from = emitter::pointModelFrom(opening, output, 0.01))
    chart.facts.push_back(fmt::format("one point is within 1 % from {:.2f} m ({:.1f} x)", *from, *from / size));
  return chart;
}

bool drawLuminaire(const PhotometricFile& file, const std::string& kind, const std::string& picture,
                   core::Diagnostics& warnings) {
  if (!picture.ends_with(".png") && !picture.ends_with(".svg")) {
    throw core::InputError({}, "picture-format", picture + ": pictures are written as .png or .svg; name the file so");
  }
  core::Value json;
  if (kind == "polar") {
    json = plot::toJson(polarDiagramOf(file));
  } else if (kind == "cartesian") {
    json = plot::toJson(cartesianDiagramOf(file));
  } else if (kind == "solid") {
    json = plot::toJson(photometricSolidOf(file));
  } else if (kind == "near-field") {
    json = plot::toJson(nearFieldChartOf(file));
  } else {
    throw core::InputError({}, "bad-option",
                           fmt::format("--diagram {}: take polar, cartesian, solid or near-field", kind));
  }
  const fs::path target = picture;
  const std::string figure = (target.parent_path() / (target.stem().string() + ".figure.json")).string();
  core::writeFile(figure, core::toJson(json));
  std::error_code error;
  fs::remove(target, error);  // an earlier picture must not pass for this one
  if (const std::string trouble = drawFigure(figure, {picture}); !trouble.empty()) {
    warnings.warning({}, "cannot-draw",
                     fmt::format("drawing is not possible here: {}; the numbers are in {}", trouble, figure));
    return false;
  }
  fs::remove(figure, error);
  return true;
}

}  // namespace goniolux::pipeline
