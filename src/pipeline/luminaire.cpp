// The luminaire stage: reads photometric files and says what they are, what they give, and what is doubtful about them.
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "photometry/photometric_file.h"
#include "pipeline/luminaire_sheet.h"
#include "pipeline/polar.h"
#include "pipeline/stages.h"

namespace goniolux::pipeline {
namespace {

using core::Value;

Value errorDocument(const std::string& file, const core::Diagnostic& diagnostic) {
  Value error;
  error.set("line", diagnostic.position.line);
  error.set("column", diagnostic.position.column);
  error.set("rule", diagnostic.rule);
  error.set("message", diagnostic.message);
  Value entry;
  entry.set("file", file);
  entry.set("error", error);
  return entry;
}

// The first error of the list; what stopped the reader.
const core::Diagnostic& firstError(const core::Diagnostics& diagnostics) {
  for (const core::Diagnostic& d : diagnostics.all()) {
    if (d.severity == core::Severity::error) return d;
  }
  return diagnostics.all().front();
}

std::string option(const StageRequest& request, const char* key) {
  const auto found = request.options.find(key);
  return found == request.options.end() ? std::string() : found->second;
}

photometry::Strictness strictness(const StageRequest& request) {
  const std::string mode = option(request, "mode");
  if (mode == "strict") return photometry::Strictness::strict;
  if (mode.empty() || mode == "lenient") return photometry::Strictness::lenient;
  throw core::InputError({}, "bad-option", fmt::format("--mode {}: take lenient or strict", mode));
}

// One picture for one file; with several files, NAME of each stands before the ending: sheets.png, sheets-panel.png.
std::string pictureFor(const std::string& file, const std::string& picture, bool alone) {
  if (alone) return picture;
  namespace fs = std::filesystem;
  const fs::path path = picture;
  return (path.parent_path() /
          (path.stem().string() + "-" + fs::path(file).filename().string() + path.extension().string()))
      .string();
}

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  StageReport report;
  const photometry::Strictness mode = strictness(request);
  const std::string picture = option(request, "plot");
  Value::Array entries;
  double done = 0;
  for (const std::string& path : request.inputs) {
    progress.progress("luminaire", done / static_cast<double>(request.inputs.size()), path);
    try {
      const photometry::PhotometricFile file = photometry::readPhotometricFile(path, mode);
      entries.push_back(luminaireDocument(file));
      if (!report.text.empty()) report.text += '\n';
      report.text += luminaireText(file);
      if (!picture.empty()) {
        const std::string name = pictureFor(path, picture, request.inputs.size() == 1);
        if (drawPolarDiagram(file, name, report.warnings)) report.files.push_back(name);
      }
    } catch (const core::InputError& error) {  // the other files are still worth reading
      entries.push_back(errorDocument(path, firstError(error.diagnostics())));
      report.warnings.append(error.diagnostics());
      report.inputFailed = true;
    }
    done += 1;
    if (progress.cancelled()) {
      report.unfinished = true;
      break;
    }
  }
  report.json = entries;
  return report;
}

core::Parameter textOption(const char* key, const char* title, const char* fallback, const char* help) {
  core::Parameter parameter;
  parameter.key = key;
  parameter.title = title;
  parameter.kind = core::ParameterKind::text;
  parameter.defaultText = fallback;
  parameter.help = help;
  return parameter;
}

}  // namespace

Stage luminaireStage() {
  Stage stage;
  stage.name = "luminaire";
  stage.title = "show what a photometric file says and gives";
  stage.help =
      "Reads LM-63 (.ies, 1986 to 2019), EULUMDAT (.ldt) and TM-33 (.xml) files and prints for each: format, symmetry, "
      "luminous opening, the exact, the "
      "zonal-constant and the declared flux, largest intensity, beam and field angles, CIE flux code, zonal flux, and "
      "every assumption that "
      "was made in reading, with its line and rule. A file that cannot be read gets a message with its line; the "
      "others are still shown.";
  stage.inputName = "FILE";
  stage.manyInputs = true;
  stage.options = {
      textOption("plot", "picture of the file's diagram", "", "ends in .png or .svg; drawn by goniolux-plot"),
      textOption("mode", "how the file is read", "lenient",
                 "lenient: what is unambiguous is read, with warnings; strict: a departure from the "
                 "format is an error")};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
