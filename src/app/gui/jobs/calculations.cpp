#include "app/gui/jobs/calculations.h"

#include <filesystem>
#include <utility>

#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "pipeline/stages.h"

namespace goniolux::gui {
namespace {

namespace fs = std::filesystem;

QString quoted(const std::string& word) {
  const bool isPlain = !word.empty() && word.find_first_of(" \t\"'$&|;<>()*?[]#~\\`!{}%") == std::string::npos;
  QString text = QString::fromStdString(word);
  return isPlain ? text : "'" + text.replace("'", "'\\''") + "'";
}

pipeline::StageReport runStage(const std::string& verb, const pipeline::StageRequest& request, JobProgress& progress) {
  for (const pipeline::Stage& stage : pipeline::stages()) {
    if (stage.name != verb) continue;
    pipeline::StageReport report = stage.run(request, progress);
    for (const core::Diagnostic& d : report.warnings.all()) progress.note(core::toString(d));
    return report;
  }
  throw core::RunError("this program has no stage " + verb);
}

}  // namespace

Job::Work gridsWork(Source source, std::function<void(GridsOutcome)> deliver) {
  return [source = std::move(source), deliver = std::move(deliver)](JobProgress& progress) {
    const project::Project project = project::readProjectText(source.text, source.file);
    if (project.grids.empty())
      throw core::InputError({source.file, 0, 0}, "no-grid",
                             "the project has no grids to calculate; add one in the project tree");
    const auto outline = std::make_shared<const pipeline::Outline>(pipeline::outlineOf(project));
    const pipeline::Engine engine(project, false);
    project::Results known;
    known.project = project.name;
    known.confidence = project.settings.accuracy.confidence;
    const auto partial = [&](const project::GridResult& grid) {
      const bool isNew = known.grids.empty() || known.grids.back().name != grid.name;
      if (isNew) known.grids.push_back(grid);
      known.grids.back() = grid;
      auto results = std::make_shared<const project::Results>(known);
      progress.publish([deliver, results, outline] { deliver({results, outline, false}); });
    };
    auto results =
        std::make_shared<const project::Results>(pipeline::calculateGrids(project, engine, progress, partial));
    progress.publish([deliver, results, outline] { deliver({results, outline, true}); });
  };
}

Job::Work earlierResultsWork(Source source, std::function<void(GridsOutcome)> deliver) {
  return [source = std::move(source), deliver = std::move(deliver)](JobProgress& progress) {
    const fs::path file = fs::path(source.file).parent_path() / "results" / project::resultsFileName;
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return;
    auto results = std::make_shared<project::Results>();
    try {
      *results = project::readResults(file.string());
      const project::Project project = project::readProjectText(source.text, source.file);
      if (results->projectHash != project.hash) return;
      auto outline = std::make_shared<const pipeline::Outline>(pipeline::outlineOf(project));
      progress.publish([deliver, results, outline] { deliver({results, outline, true}); });
    } catch (const core::InputError& error) {
      progress.note(std::string("earlier results are not shown: ") + error.what());
    }
  };
}

Job::Work writeResultsWork(Source source, std::shared_ptr<const project::Results> results, std::string folder,
                           std::function<void(std::vector<std::string>)> deliver) {
  return [=](JobProgress& progress) {
    const project::Project project = project::readProjectText(source.text, source.file);
    std::vector<std::string> files = pipeline::writeResults(project, *results, folder);
    progress.note("results are in " + folder);
    progress.publish([deliver, files] { deliver(files); });
  };
}

Job::Work reportWork(Source source, std::shared_ptr<const project::Results> results, std::string file,
                     std::string language, std::function<void()> deliver) {
  return [=](JobProgress& progress) {
    const project::Project project = project::readProjectText(source.text, source.file);
    const fs::path folder = fs::path(source.file).parent_path() / "results";
    pipeline::writeResults(project, *results, folder.string());
    for (const scene::View& view : project.views) {
      const fs::path image = folder / (project::fileNameFor(view.name) + ".exr");
      std::error_code ignored;
      if (!fs::exists(image, ignored)) continue;
      pipeline::StageRequest shown;
      shown.inputs = {image.string()};
      shown.common.output = fs::path(image).replace_extension(".png").string();
      runStage("display", shown, progress);
    }
    pipeline::StageRequest request;
    request.inputs = {folder.string()};
    request.options["language"] = language;
    const bool wantsPdf = fs::path(file).extension() != ".html";
    if (!wantsPdf) request.options["format"] = "html";
    const pipeline::StageReport report = runStage("report", request, progress);
    const fs::path made = folder / (wantsPdf ? "report.pdf" : "report.html");
    std::error_code missing;
    if (!fs::exists(made, missing)) {
      for (const core::Diagnostic& d : report.warnings.all())
        if (d.rule == "no-pdf") throw core::RunError(d.message);
      throw core::RunError("the report was stopped before it was written");
    }
    if (fs::absolute(file).lexically_normal() != fs::absolute(made).lexically_normal())
      core::writeFile(file, core::readFile(made.string()));
    progress.publish(deliver);
  };
}

Job::Work stageWork(const std::string& verb, pipeline::StageRequest request,
                    std::function<void(const pipeline::StageReport&)> deliver) {
  return [verb, request = std::move(request), deliver = std::move(deliver)](JobProgress& progress) {
    auto report = std::make_shared<pipeline::StageReport>(runStage(verb, request, progress));
    progress.publish([deliver, report] { deliver(*report); });
  };
}

QString commandLine(const std::string& verb, const pipeline::StageRequest& request) {
  QStringList words{"goniolux", QString::fromStdString(verb)};
  for (const std::string& input : request.inputs) words << quoted(input);
  const auto add = [&](const char* option, const std::string& value) { words << option << quoted(value); };
  if (request.common.output) add("-o", *request.common.output);
  if (request.common.accuracy) add("--accuracy", *request.common.accuracy);
  if (request.common.scene) add("--scene", *request.common.scene);
  if (request.common.timeLimit_s) add("--time-limit", QString::number(*request.common.timeLimit_s).toStdString());
  for (const std::string& setting : request.common.set) add("--set", setting);
  for (const auto& [key, value] : request.options) words << QString::fromStdString("--" + key) << quoted(value);
  return words.join(' ');
}

}  // namespace goniolux::gui
