#include "pipeline/luminaire_tools.h"

#include <fmt/format.h>

#include <cmath>

#include "core/document.h"
#include "photometry/comparison.h"
#include "photometry/transform.h"
#include "photometry/writers.h"
#include "pipeline/luminaire_sheet.h"

namespace goniolux::pipeline {
namespace {

using core::Value;
using photometry::DistributionDifference;
using photometry::PhotometricFile;

Value differenceDocument(const DistributionDifference& d, double flux) {
  Value value;
  value.set("misplaced_lm", d.misplaced);
  value.set("misplaced_share", flux > 0 ? Value(d.misplaced / flux) : Value());
  value.set("rms_cd", d.rms);
  value.set("largest_cd", d.largest);
  value.set("largest_at", Value(Value::Object{{"c", d.c}, {"gamma", d.gamma}}));
  return value;
}

}  // namespace

StageReport convertLuminaire(const std::string& in, const std::string& out, double turnDegrees,
                             photometry::Strictness strictness) {
  const PhotometricFile read = photometry::readPhotometricFile(in, strictness);
  PhotometricFile file = photometry::turned(read, turnDegrees);
  StageReport report;
  core::Diagnostics warnings;
  const std::string bytes = photometry::writePhotometry(file, out, warnings);
  // What was written is read by the same reader that others' files meet.
  const PhotometricFile back = photometry::readPhotometry(bytes, out);
  core::writeFile(out, bytes);
  const double change = photometry::largestChange(*file.distribution, *back.distribution);
  report.warnings.append(warnings);
  report.files.push_back(out);
  report.text = fmt::format("{}, {} -> {}, {}\n", in, read.format, out, back.format);
  report.text += fmt::format("  {:<26}{:.10g} -> {:.10g} {}\n", "exact flux", file.distribution->flux(),
                             back.distribution->flux(), file.fluxUnit);
  report.text += fmt::format("  {:<26}{:.3g} {} of {:.6g} at most\n", "change of the intensities", change,
                             file.intensityUnit, file.distribution->maximumIntensity());
  if (turnDegrees != 0) report.text += fmt::format("  {:<26}what was at C0 is at C{:g}\n", "turned", turnDegrees);
  report.json.set("from", in);
  report.json.set("to", out);
  report.json.set("format", back.format);
  report.json.set("turned_deg", turnDegrees);
  report.json.set("flux_before", file.distribution->flux());
  report.json.set("flux_after", back.distribution->flux());
  report.json.set("largest_change", change);
  Value list = Value::Array{};
  for (const core::Diagnostic& d : report.warnings.all()) list.push(d.message);
  report.json.set("warnings", list);
  return report;
}

StageReport compareLuminaires(const std::string& nameA, const std::string& nameB, photometry::Strictness strictness) {
  const PhotometricFile a = photometry::readPhotometricFile(nameA, strictness),
                        b = photometry::readPhotometricFile(nameB, strictness);
  StageReport report;
  const double fluxA = a.distribution->flux(), fluxB = b.distribution->flux();
  const double peakA = a.distribution->maximumIntensity(), peakB = b.distribution->maximumIntensity();
  const auto percent = [](double from, double to) {
    // Rounded first: + 0.0 turns -0 into 0.
    return from > 0 ? fmt::format("{:+.2f} %", std::round(1e4 * (to / from - 1)) / 100 + 0.0) : std::string();
  };
  const auto row = [&](const char* name, const std::string& inA, const std::string& inB, const std::string& change) {
    report.text += fmt::format("  {:<20}{:>22}  {:>22}  {:>10}\n", name, inA, inB, change);
  };
  report.text = fmt::format("A  {}\nB  {}\n", nameA, nameB);
  row("", "A", "B", "B to A");
  row("format", a.format, b.format, "");
  row("symmetry", a.symmetry, b.symmetry, "");
  row("exact flux", fmt::format("{:.2f} {}", fluxA, a.fluxUnit), fmt::format("{:.2f} {}", fluxB, b.fluxUnit),
      percent(fluxA, fluxB));
  row("largest intensity", fmt::format("{:.2f} {}", peakA, a.intensityUnit),
      fmt::format("{:.2f} {}", peakB, b.intensityUnit), percent(peakA, peakB));
  row("input", fmt::format("{:g} W", a.inputWatts), fmt::format("{:g} W", b.inputWatts),
      percent(a.inputWatts, b.inputWatts));
  report.text += fmt::format("  opening of A        {}\n  opening of B        {}\n", openingText(a.opening),
                             openingText(b.opening));
  report.text += "  intensities apart   misplaced flux         RMS     largest at\n";
  Value turns = Value::Array{};
  double least = 0, leastTurn = 0;
  for (const double turn : {0.0, 90.0, 180.0, 270.0}) {
    const DistributionDifference d =
        turn == 0 ? difference(*a.distribution, *b.distribution)
                  : difference(*a.distribution, photometry::TurnedDistribution(b.distribution, turn));
    if (turn == 0 || d.misplaced < least * (1 - 1e-6) - 1e-9) {
      least = d.misplaced;
      leastTurn = turn;
    }
    report.text +=
        fmt::format("    {:<16}  {:>10.2f} {} {:>7.2f} %  {:>8.2f}  {:>8.2f} {} at C {:g}, gamma {:g}\n",
                    turn == 0 ? "as they are" : fmt::format("B turned by {:g}", turn), d.misplaced, a.fluxUnit,
                    fluxA > 0 ? 100 * d.misplaced / fluxA : 0, d.rms, d.largest, a.intensityUnit, d.c, d.gamma);
    Value entry = differenceDocument(d, fluxA);
    entry.set("turn_deg", turn);
    turns.push(entry);
  }
  if (leastTurn != 0) {
    report.text += fmt::format(
        "  B turned by {0:g} degrees is nearer to A: the files may differ about where C0 lies; turn one with\n"
        "  goniolux luminaire convert {1} OUT --turn {0:g}\n",
        leastTurn, nameB);
  }
  report.json.set("a", luminaireDocument(a));
  report.json.set("b", luminaireDocument(b));
  report.json.set("flux_ratio", fluxA > 0 ? Value(fluxB / fluxA) : Value());
  report.json.set("differences", turns);
  report.json.set("nearest_turn_deg", leastTurn);
  return report;
}

}  // namespace goniolux::pipeline
