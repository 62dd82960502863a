// The spectrum stage: colorimetry of lamp spectra, from files or by the name of a built-in illuminant.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include "core/document.h"
#include "pipeline/stages.h"
#include "plot/spectrum_svg.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "spectrum/colour_rendering.h"
#include "spectrum/spectrum_files.h"
#include "spectrum/tm30.h"

namespace goniolux::pipeline {
namespace {

using core::Value;

// Off the Planckian locus by more than this, a correlated colour temperature means nothing — CIE 015:2018, 9.4 (in u',
// v').
constexpr double farthestForTemperature = 0.05;

constexpr std::pair<const char*, spectrum::AlphaOpic> alphaOpicKeys[] = {{"s_cone", spectrum::AlphaOpic::sCone},
                                                                         {"m_cone", spectrum::AlphaOpic::mCone},
                                                                         {"l_cone", spectrum::AlphaOpic::lCone},
                                                                         {"rhodopic", spectrum::AlphaOpic::rhodopic},
                                                                         {"melanopic", spectrum::AlphaOpic::melanopic}};

spectrum::SpectralDistribution readSource(const std::string& name, core::Diagnostics& warnings) {
  if (const auto builtIn = spectrum::illuminant(name)) return *builtIn;
  return spectrum::readSpectrumFile(name, spectrum::Role::source, &warnings);
}

void describe(const std::string& name, const spectrum::SpectralDistribution& source, Value& entry, std::string& text) {
  const spectrum::Xyz raw = spectrum::tristimulus(source);
  const spectrum::Xyz colour{100 * raw.X / raw.Y, 100, 100 * raw.Z / raw.Y};
  const auto [x, y] = spectrum::chromaticity(colour);
  const auto [u, v] = spectrum::uvPrime(colour);
  const auto [kelvin, duv] = spectrum::colourTemperature(colour);
  const double melanopic = spectrum::melanopicDer(source), scotopic = spectrum::scotopicPhotopicRatio(source);
  const spectrum::ColourRendering rendering = spectrum::colourRendering(source);
  const spectrum::ColourFidelity fidelity = spectrum::colourFidelity(source);
  entry.set("X", colour.X);
  entry.set("Y", colour.Y);
  entry.set("Z", colour.Z);
  entry.set("x", x);
  entry.set("y", y);
  entry.set("u_prime", u);
  entry.set("v_prime", v);
  const bool hasTemperature = std::abs(duv) <= farthestForTemperature;
  entry.set("cct_k", hasTemperature ? Value(kelvin) : Value());
  entry.set("duv", duv);
  entry.set("ra", hasTemperature ? Value(rendering.ra) : Value());
  entry.set("r9", hasTemperature ? Value(rendering.special[8]) : Value());
  entry.set("rf", hasTemperature ? Value(fidelity.rf) : Value());
  entry.set("rg", hasTemperature ? Value(fidelity.rg) : Value());
  entry.set("melanopic_der", melanopic);
  entry.set("s_p", scotopic);
  Value ratios;
  for (const auto& [key, response] : alphaOpicKeys) ratios.set(key, spectrum::alphaOpicDer(source, response));
  entry.set("alpha_opic_der", std::move(ratios));

  text += fmt::format("{}\n  x = {:.4f}, y = {:.4f}   u' = {:.4f}, v' = {:.4f}\n", name, x, y, u, v);
  if (hasTemperature) {
    text += fmt::format("  CCT {:.0f} K, Duv {:+.4f}\n  Ra {:.1f}, R9 {:.0f}; TM-30 Rf {:.0f}, Rg {:.0f}\n", kelvin,
                        duv, rendering.ra, rendering.special[8], fidelity.rf, fidelity.rg);
  } else {
    text += fmt::format("  no correlated colour temperature and no colour rendering: Duv is {:+.3f}\n", duv);
  }
  text += fmt::format("  melanopic daylight efficacy ratio {:.3f}, S/P ratio {:.2f}\n", melanopic, scotopic);
}

plot::SpectrumPlot plotOf(const std::string& name, const spectrum::SpectralDistribution& source, const Value& entry) {
  plot::SpectrumPlot plot;
  plot.title = std::filesystem::path(name).filename().string();
  plot.source = source;
  const auto number = [&](const char* key) { return entry.find(key)->number(); };
  plot.facts = {fmt::format("x = {:.4f}, y = {:.4f}", number("x"), number("y"))};
  if (!entry.find("cct_k")->isNull()) {
    plot.facts.push_back(fmt::format("{:.0f} K, Duv {:+.4f}", number("cct_k"), number("duv")));
    plot.facts.push_back(fmt::format("Ra {:.0f}, R9 {:.0f}", number("ra"), number("r9")));
    plot.facts.push_back(fmt::format("Rf {:.0f}, Rg {:.0f}", number("rf"), number("rg")));
  }
  plot.facts.push_back(fmt::format("melanopic DER {:.2f}", number("melanopic_der")));
  return plot;
}

void checkOutput(const StageRequest& request) {
  const auto& output = request.common.output;
  if (!output) return;
  if (!output->ends_with(".svg"))
    throw core::InputError({}, "picture-format", *output + ": plots of spectra are written as .svg; name the file so");
  if (request.inputs.size() != 1)
    throw core::InputError({}, "one-picture", "one plot shows one spectrum; give one file with -o");
}

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  checkOutput(request);
  StageReport report;
  report.json = Value(Value::Array{});
  double done = 0;
  for (const std::string& input : request.inputs) {
    progress.progress("spectra", done++ / static_cast<double>(request.inputs.size()), input);
    Value entry;
    entry.set("file", input);
    try {
      core::Diagnostics warnings;
      const auto source = readSource(input, warnings);
      describe(input, source, entry, report.text);
      if (request.common.output) {
        core::writeFile(*request.common.output, plot::spectrumSvg(plotOf(input, source, entry)));
        report.files.push_back(*request.common.output);
      }
      report.warnings.append(warnings);
    } catch (const core::InputError& error) {
      const core::Diagnostic& first = error.diagnostics().all().front();
      Value problem;
      problem.set("line", first.position.line);
      problem.set("column", first.position.column);
      problem.set("message", first.message);
      entry.set("error", problem);
      report.text += std::string(error.what()) + "\n";
      report.inputFailed = true;
    }
    report.json.push(entry);
  }
  return report;
}

}  // namespace

Stage spectrumStage() {
  Stage stage;
  stage.name = "spectrum";
  stage.title = "Colour of lamp spectra: chromaticity, CCT, rendering";
  stage.help =
      "Reads spectra (.spd, .csv, TM-27 .spdx) or takes built-in ones by name (\"CIE FL11\") and gives X, Y, Z (Y = "
      "100), x, y, u', v', correlated colour temperature and Duv for the CIE 1931 observer, Ra and R9 (CIE 13.3), Rf "
      "and "
      "Rg (TM-30), the melanopic and the other alpha-opic daylight efficacy ratios (CIE S 026) and the S/P ratio. With "
      "-o "
      "FILE.svg the spectrum is plotted.";
  stage.inputName = "FILE";
  stage.manyInputs = true;
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
