#include "pipeline/luminaire_sheet.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "photometry/flux_check.h"
#include "photometry/metrics.h"

namespace goniolux::pipeline {
namespace {

using core::Value;
using photometry::PhotometricFile;
using photometry::PrincipalPlane;
using photometry::StatedOpening;

const char* typeName(photometry::PhotometryType type) {
  switch (type) {
    case photometry::PhotometryType::a:
      return "A";
    case photometry::PhotometryType::b:
      return "B";
    case photometry::PhotometryType::c:
      break;
  }
  return "C";
}

const char* axisName(StatedOpening::Axis axis) {
  switch (axis) {
    case StatedOpening::Axis::lengthwise:
      return "length";
    case StatedOpening::Axis::widthwise:
      return "width";
    case StatedOpening::Axis::aim:
      break;
  }
  return "aim";
}

Value orNull(const std::optional<double>& value) {
  return value ? Value(*value) : Value();
}

Value planesDocument(const PhotometricFile& file, double fraction) {
  Value planes;
  planes.set("c0_180", orNull(photometry::fullWidth(*file.distribution, PrincipalPlane::c0_180, fraction)));
  planes.set("c90_270", orNull(photometry::fullWidth(*file.distribution, PrincipalPlane::c90_270, fraction)));
  return planes;
}

Value openingDocument(const StatedOpening& opening) {
  Value value;
  value.set("shape", shapeName(opening));
  value.set("axis", axisName(opening.axis));
  value.set("length_m", opening.length);
  value.set("width_m", opening.width);
  value.set("height_m", opening.height);
  value.set("length_along", opening.lengthAlongC90 ? "c90" : "c0");
  if (!opening.note.empty()) value.set("note", opening.note);
  return value;
}

std::optional<double> efficacy(const PhotometricFile& file) {
  if (file.inputWatts <= 0 || file.radiometric) return std::nullopt;
  return file.distribution->flux() / file.inputWatts;
}

// The flux that the file declares: of its lamps, or of the luminaire where photometry is absolute.
std::optional<double> declaredFlux(const PhotometricFile& file) {
  return file.absolute ? file.declaredLuminaireLumens : file.declaredLumens;
}

// Light output ratio from the table; none without lamp flux.
std::optional<double> outputRatio(const PhotometricFile& file) {
  if (!file.declaredLumens) return std::nullopt;
  return file.distribution->flux() / *file.declaredLumens;
}

std::string keyword(const PhotometricFile& file, const char* key) {
  const auto found = file.keywords.find(key);
  if (found == file.keywords.end()) return "";
  return found->second.substr(0, found->second.find('\n'));
}

std::string titleLine(const PhotometricFile& file) {
  std::string title;
  for (const char* key : {"LUMINAIRE", "LUMCAT", "MANUFAC"}) {
    const std::string value = keyword(file, key);
    if (!value.empty()) title += (title.empty() ? "" : " | ") + value;
  }
  return title;
}

std::string row(const std::string& label, const std::string& value) {
  return value.empty() ? fmt::format("  {}\n", label) : fmt::format("  {:<18}{}\n", label, value);
}

std::string fluxRow(const char* label, double value, double exact, const char* remark) {
  const double percent = exact > 0 ? std::round(1e4 * (value / exact - 1)) / 100 + 0.0 : 0;  // + 0.0 turns -0 into 0
  const std::string difference = fmt::format("{:+.2f} %", percent);
  return fmt::format("    {:<16}{:>12.2f}  {:>10}  {}\n", label, value, difference, remark);
}

std::string fluxesText(const PhotometricFile& file) {
  const double exact = file.distribution->flux();
  std::string text = row("luminous flux", file.radiometric ? file.fluxUnit + " (no photometric file)" : "lm");
  text += fmt::format("    {:<16}{:>12.2f}  {:>10}  {}\n", "exact", exact, "",
                      "integral of the interpolated table: what is used");
  text += fluxRow("zonal constant", photometry::zonalConstantFlux(*file.distribution), exact,
                  "sum over zones, as laboratories print it");
  if (file.declaredLuminaireLumens)
    text += fluxRow("declared", *file.declaredLuminaireLumens, exact, "of the luminaire, by the file");
  if (file.declaredLumens) {
    text += fmt::format("    {:<16}{:>12.2f}  {:>10}  light output ratio {:.1f} %{}\n", "lamps", *file.declaredLumens,
                        "", 100 * *outputRatio(file),
                        file.lightOutputRatio ? fmt::format(", {:g} % by the file", 100 * *file.lightOutputRatio) : "");
  }
  const double down = file.distribution->forwardFlux();
  const double share = exact > 0 ? 100 * down / exact : 0;
  text += fmt::format("    {:<16}{:>12.2f}  {:>8.1f} %  gamma below 90 degrees\n", "downward", down, share);
  text += fmt::format("    {:<16}{:>12.2f}  {:>8.1f} %\n", "upward", exact - down, exact > 0 ? 100 - share : 0);
  return text;
}

std::string widthsText(const PhotometricFile& file, const char* label, double fraction) {
  const auto text = [&](PrincipalPlane plane) {
    const auto width = photometry::fullWidth(*file.distribution, plane, fraction);
    return width ? fmt::format("{:.1f} deg", *width) : std::string("none");
  };
  return row(label, fmt::format("{} in C0-C180, {} in C90-C270 (to {:g} % of each plane's maximum)",
                                text(PrincipalPlane::c0_180), text(PrincipalPlane::c90_270), 100 * fraction));
}

std::string fluxCodeText(const PhotometricFile& file) {
  std::string text;
  for (const double n : photometry::cieFluxCode(*file.distribution, file.declaredLumens))
    text += fmt::format("{}{:.0f}", text.empty() ? "" : " ", n);
  return row("CIE flux code", text);
}

std::string zonesText(const PhotometricFile& file) {
  const std::array<double, 18> zones = photometry::zonalLumens(*file.distribution);
  const double exact = file.distribution->flux();
  if (exact <= 0) return "";
  std::string text = row("zonal flux", "gamma, " + file.fluxUnit + ", share");
  for (std::size_t i = 0; i < zones.size(); ++i) {
    if (zones[i] <= 0) continue;
    text += fmt::format("    {:>3} to {:>3}      {:>12.2f}  {:>8.2f} %\n", 10 * i, 10 * i + 10, zones[i],
                        100 * zones[i] / exact);
  }
  return text;
}

std::string warningsText(const PhotometricFile& file) {
  std::string text;
  for (const core::Diagnostic& d : file.warnings.all()) {
    const std::string place = d.position.line > 0 ? fmt::format("line {}", d.position.line) : "whole file";
    text += fmt::format("    {:<11} {}: {}\n", place, d.rule, d.message);
  }
  return text.empty() ? "" : row("warnings", "") + text;
}

}  // namespace

const char* shapeName(const StatedOpening& opening) {
  const bool round = opening.length == opening.width;
  switch (opening.shape) {
    case StatedOpening::Shape::point:
      return "point";
    case StatedOpening::Shape::line:
      return "line";
    case StatedOpening::Shape::rectangle:
      return "rectangle";
    case StatedOpening::Shape::disc:
      return round || opening.axis != StatedOpening::Axis::aim ? "disc" : "ellipse";
    case StatedOpening::Shape::box:
      return "box";
    case StatedOpening::Shape::cylinder:
      return "cylinder";
    case StatedOpening::Shape::sphere:
      return round && opening.length == opening.height ? "sphere" : "ellipsoid";
    case StatedOpening::Shape::other:
      break;
  }
  return "other";
}

std::string openingText(const StatedOpening& o) {
  if (o.shape == StatedOpening::Shape::point) return "point";
  if (o.shape == StatedOpening::Shape::other) return o.note;
  const char* along = o.lengthAlongC90 ? "C90" : "C0";
  const char* across = o.lengthAlongC90 ? "C0" : "C90";
  std::string text = shapeName(o);
  if (o.shape == StatedOpening::Shape::cylinder || o.shape == StatedOpening::Shape::disc) {
    if (o.axis != StatedOpening::Axis::aim)
      text = fmt::format("{} with its axis along {}", text, o.axis == StatedOpening::Axis::lengthwise ? along : across);
    else if (o.shape == StatedOpening::Shape::cylinder)
      text = "upright " + text;
  } else if (o.axis != StatedOpening::Axis::aim) {
    text = "upright " + text;
  }
  if (o.length > 0) text += fmt::format(", {:g} m along {}", o.length, along);
  if (o.width > 0) text += fmt::format(", {:g} m along {}", o.width, across);
  if (o.height > 0) text += fmt::format(", {:g} m high", o.height);
  return text;
}

Value luminaireDocument(const PhotometricFile& file) {
  const photometry::TabulatedDistribution& d = *file.distribution;
  const photometry::IntensityPeak peak = photometry::intensityPeak(d);
  Value v;
  v.set("file", file.file);
  v.set("format", file.format);
  v.set("photometric_type", typeName(d.type()));
  v.set("absolute", file.absolute);
  v.set("radiometric", file.radiometric);
  v.set("symmetry", file.symmetry);
  v.set("c_planes", static_cast<double>(d.horizontalAngles().size()));
  v.set("gamma_angles", static_cast<double>(d.verticalAngles().size()));
  v.set("declared_lumens", orNull(declaredFlux(file)));
  v.set("declared_luminaire_lumens", orNull(file.declaredLuminaireLumens));
  v.set("integrated_lumens", d.flux());
  v.set("zonal_constant_lumens", photometry::zonalConstantFlux(d));
  v.set("light_output_ratio", orNull(outputRatio(file)));
  v.set("downward_fraction", d.flux() > 0 ? Value(d.forwardFlux() / d.flux()) : Value());
  v.set("max_intensity_cd", peak.intensity_cd);
  Value at;
  at.set("c", peak.c);
  at.set("gamma", peak.gamma);
  v.set("max_direction", at);
  const std::array<double, 18> zones = photometry::zonalLumens(d);
  v.set("zonal_lumens", Value::arrayOf(std::vector<double>(zones.begin(), zones.end())));
  v.set("beam_angle_deg", planesDocument(file, 0.5));
  v.set("field_angle_deg", planesDocument(file, 0.1));
  v.set("input_watts", file.inputWatts > 0 ? Value(file.inputWatts) : Value());
  v.set("efficacy_lm_w", orNull(efficacy(file)));
  v.set("opening", openingDocument(file.opening));
  std::vector<double> code;
  for (const double n : photometry::cieFluxCode(d, file.declaredLumens)) code.push_back(std::round(n));
  v.set("cie_flux_code", Value::arrayOf(code));
  Value::Array warnings;
  for (const core::Diagnostic& diagnostic : file.warnings.all()) {
    Value warning;
    warning.set("line", diagnostic.position.line);
    warning.set("rule", diagnostic.rule);
    warning.set("message", diagnostic.message);
    warnings.push_back(warning);
  }
  v.set("warnings", warnings);
  return v;
}

std::string luminaireText(const PhotometricFile& file) {
  const photometry::TabulatedDistribution& d = *file.distribution;
  const photometry::IntensityPeak peak = photometry::intensityPeak(d);
  std::string text = file.file + "\n";
  if (const std::string title = titleLine(file); !title.empty()) text += "  " + title + "\n";
  text += row("format", fmt::format("{}, photometry type {}, {}", file.format, typeName(d.type()),
                                    file.absolute ? "absolute" : "relative to its lamps"));
  text += row("table", fmt::format("{} {} x {} vertical angles, symmetry: {}", d.horizontalAngles().size(),
                                   d.horizontalAngles().size() == 1 ? "plane" : "planes", d.verticalAngles().size(),
                                   file.symmetry));
  text += row("luminous opening", openingText(file.opening));
  const auto lumensPerWatt = efficacy(file);
  text +=
      row("input", file.inputWatts > 0 ? fmt::format("{:g} W{}", file.inputWatts,
                                                     lumensPerWatt ? fmt::format(", {:.1f} lm/W", *lumensPerWatt) : "")
                                       : "not stated");
  text += fluxesText(file);
  text += row("largest intensity", fmt::format("{:.6g} {} at C {:g}, gamma {:g}", peak.intensity_cd, file.intensityUnit,
                                               peak.c, peak.gamma));
  text += widthsText(file, "beam angle", 0.5) + widthsText(file, "field angle", 0.1);
  text += fluxCodeText(file) + zonesText(file) + warningsText(file);
  return text;
}

}  // namespace goniolux::pipeline
