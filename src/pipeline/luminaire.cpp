// The luminaire stage: reads photometric files and says what they are, what they give, and what is doubtful about them.
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "core/text.h"
#include "photometry/photometric_file.h"
#include "pipeline/luminaire_figures.h"
#include "pipeline/luminaire_sheet.h"
#include "pipeline/luminaire_tables.h"
#include "pipeline/luminaire_tools.h"
#include "pipeline/stages.h"
#include "project/reading.h"

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

double turnOf(const StageRequest& request) {
  const std::string text = option(request, "turn");
  return text.empty() ? 0 : core::parseNumber(text).value_or(0);  // the command line has checked that it is a number
}

bool isFull(const StageRequest& request) {
  const std::string sheet = option(request, "sheet");
  if (sheet.empty() || sheet == "short") return false;
  if (sheet == "full") return true;
  throw core::InputError({}, "bad-option", fmt::format("--sheet {}: take short or full", sheet));
}

/// A name that is no file here may be one of the program's own ("panel-600.ies", also with "luminaires/" before it).
std::string foundPath(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path given = name;
  if (given.empty() || given.is_absolute() || fs::exists(given, ignored)) return name;
  for (const fs::path& folder : project::programDataFolders()) {
    const fs::path own = *given.begin() == "luminaires" ? folder / given : folder / "luminaires" / given;
    if (fs::is_regular_file(own, ignored)) return own.lexically_normal().string();
  }
  return name;
}

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  StageReport report;
  const photometry::Strictness mode = strictness(request);
  const std::string& first = request.inputs.front();
  if (first == "convert" || first == "compare") {
    if (request.inputs.size() != 3) {
      throw core::InputError({}, "usage",
                             first == "convert" ? "goniolux luminaire convert needs IN and OUT"
                                                : "goniolux luminaire compare needs two files, A and B");
    }
    return first == "convert" ? convertLuminaire(request.inputs[1], request.inputs[2], turnOf(request), mode)
                              : compareLuminaires(request.inputs[1], request.inputs[2], mode);
  }
  const bool full = isFull(request);
  const std::string picture = option(request, "plot");
  const std::string diagram = option(request, "diagram").empty() ? "polar" : option(request, "diagram");
  Value::Array entries;
  double done = 0;
  for (const std::string& path : request.inputs) {
    progress.progress("luminaire", done / static_cast<double>(request.inputs.size()), path);
    try {
      const photometry::PhotometricFile file = photometry::readPhotometricFile(foundPath(path), mode);
      entries.push_back(luminaireDocument(file));
      if (full) addTables(file, entries.back());
      if (!report.text.empty()) report.text += '\n';
      report.text += luminaireText(file);
      if (full) report.text += tablesText(file);
      if (!picture.empty()) {
        const std::string name = pictureFor(path, picture, request.inputs.size() == 1);
        if (drawLuminaire(file, diagram, name, report.warnings)) report.files.push_back(name);
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

core::Parameter turnOption() {
  core::Parameter parameter =
      textOption("turn", "angle", "0", "for convert: what was at C0 is at this angle afterwards");
  parameter.kind = core::ParameterKind::number;
  parameter.unit = "degrees";
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
      "others are still shown. 'goniolux luminaire convert IN OUT' writes IN as LM-63-2019 (.ies), EULUMDAT (.ldt) or "
      "TM-33 (.xml); 'goniolux luminaire compare A B' says how far two files are apart.";
  stage.inputName = "FILE";
  stage.manyInputs = true;
  stage.options = {
      textOption("plot", "picture of the file's diagram", "", "ends in .png or .svg; drawn by goniolux-plot"),
      textOption(
          "diagram", "what is drawn", "polar",
          "polar, cartesian, solid (the photometric solid) or near-field (error of the point model over distance)"),
      textOption("sheet", "what is shown", "short",
                 "full: also spacing criterion, utilisation factors, UGR table, and the paper's diagrams beside the "
                 "table"),
      turnOption(),
      textOption("mode", "how the file is read", "lenient",
                 "lenient: what is unambiguous is read, with warnings; strict: a departure from the "
                 "format is an error")};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
