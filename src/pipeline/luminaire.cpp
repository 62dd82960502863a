// The luminaire stage: reads photometric files and says what they are, what they give, and what is doubtful about them.
#include <string>

#include "photometry/photometric_file.h"
#include "pipeline/luminaire_sheet.h"
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

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  StageReport report;
  Value::Array entries;
  double done = 0;
  for (const std::string& path : request.inputs) {
    progress.progress("luminaire", done / static_cast<double>(request.inputs.size()), path);
    try {
      const photometry::PhotometricFile file = photometry::readPhotometricFile(path);
      entries.push_back(luminaireDocument(file));
      if (!report.text.empty()) report.text += '\n';
      report.text += luminaireText(file);
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

}  // namespace

Stage luminaireStage() {
  Stage stage;
  stage.name = "luminaire";
  stage.title = "show what a photometric file says and gives";
  stage.help =
      "Reads LM-63 (.ies, 1986 to 2019) and EULUMDAT (.ldt) files and prints for each: format, symmetry, luminous "
      "opening, the exact, the "
      "zonal-constant and the declared flux, largest intensity, beam and field angles, CIE flux code, zonal flux, and "
      "every assumption that "
      "was made in reading, with its line and rule. A file that cannot be read gets a message with its line; the "
      "others are still shown.";
  stage.inputName = "FILE";
  stage.manyInputs = true;
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
