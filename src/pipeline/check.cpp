// Stage `check`: reads a project with everything that it refers to, looks for what makes calculations fail, and lists
// every error and warning.
#include <fmt/format.h>

#include "pipeline/cross_check.h"
#include "pipeline/engine.h"
#include "pipeline/geometry_findings.h"
#include "pipeline/repair.h"
#include "pipeline/stages.h"
#include "project/project.h"

namespace goniolux::pipeline {
namespace {

core::Value listed(const core::Diagnostics& diagnostics, core::Severity severity) {
  core::Value::Array list;
  for (const core::Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity != severity) continue;
    core::Value entry;
    entry.set("file", diagnostic.position.file);
    entry.set("line", diagnostic.position.line);
    entry.set("column", diagnostic.position.column);
    entry.set("rule", diagnostic.rule);
    entry.set("message", diagnostic.message);
    list.push_back(std::move(entry));
  }
  return list;
}

std::string count(std::size_t number, const char* what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

std::string summary(const project::Project& project) {
  return fmt::format("{}: {}, {}, {}, {}", project.name, count(project.environment.objects.size(), "object"),
                     count(project.environment.luminaires.size(), "luminaire"), count(project.grids.size(), "grid"),
                     count(project.views.size(), "view"));
}

/// Both solvers' numbers, and pictures of where they differ.
void addCrossCheck(const StageRequest& request, core::ProgressSink& progress, StageReport& report,
                   core::Diagnostics& found) {
  const project::Project project = readProjectFor(request, AccuracyOf::grids);
  const CrossCheck check = crossCheck(project, progress);
  const std::vector<std::string> pictures = drawDifferences(check, project, resultsFolder(request, project), found);
  report.text += textOf(check);
  core::Value json = toJson(check);
  json.set("pictures", core::Value::arrayOf(pictures));
  report.json.set("cross", std::move(json));
  report.files.insert(report.files.end(), pictures.begin(), pictures.end());
  report.verdictFailed = !check.agrees();
  report.unfinished = progress.cancelled();
}

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  StageReport report;
  core::Diagnostics found;
  try {
    const project::Overrides overrides{request.common.set, request.common.scene};
    const project::Project project =
        request.projectText ? project::readProjectText(*request.projectText, request.inputs.front(), overrides)
                            : project::readProject(request.inputs.front(), overrides);
    found = project.warnings;
    findInGeometry(project, found);
    findByRays(project, found);
    report.text = summary(project) + "\n";
    if (const auto fix = request.options.find("fix"); fix != request.options.end()) {
      const std::vector<std::string> repairs = repairProject(project, fix->second);
      for (const std::string& repair : repairs) report.text += "mended: " + repair + "\n";
      report.json.set("repairs", core::Value::arrayOf(repairs));
      if (!repairs.empty()) report.files.push_back(fix->second);
    }
    if (request.options.contains("cross")) addCrossCheck(request, progress, report, found);
  } catch (const core::InputError& error) {
    // The errors are what this stage was asked for: they are its result, and the exit code still says that input is
    // bad.
    found = error.diagnostics();
    report.inputFailed = true;
  }
  report.json.set("errors", listed(found, core::Severity::error));
  report.json.set("warnings", listed(found, core::Severity::warning));
  report.warnings = found;
  report.text += fmt::format("{}, {}\n", count(report.json.find("errors")->array().size(), "error"),
                             count(report.json.find("warnings")->array().size(), "warning"));
  return report;
}

}  // namespace

Stage checkStage() {
  Stage stage;
  stage.name = "check";
  stage.title = "Check a project";
  stage.help =
      "Reads a project and every file that it refers to, and lists all errors and warnings with their places: faults "
      "of the "
      "files; holes in the room, coincident surfaces and such that run through each other, slivers, open glass, "
      "luminaires and grid points inside objects or in their faces, "
      "luminaires behind surfaces, objects that reach out of the room, an absurd scale.";
  stage.inputName = "PROJECT";
  core::Parameter fix;
  fix.key = "fix";
  fix.title = "new project file";
  fix.kind = core::ParameterKind::text;
  fix.help = "writes the project with what can be mended safely: surfaces in one plane parted, cracks in meshes joined";
  core::Parameter cross;
  cross.key = "cross";
  cross.title = "two solvers on the project";
  cross.kind = core::ParameterKind::boolean;
  cross.help =
      "calculates the grids by two solvers and names every place where they differ beyond both intervals (exit code "
      "1); "
      "cross-NAME.png shows the differences";
  stage.options = {fix, cross};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
