// Run: the main job: grids, plots, views and their pictures, into one results folder.
#include <fmt/format.h>

#include <filesystem>
#include <limits>

#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "pipeline/kept_run.h"
#include "pipeline/render.h"
#include "pipeline/requirements.h"
#include "pipeline/stages.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

void append(StageReport& report, const StageReport& part) {
  report.text += part.text;
  report.files.insert(report.files.end(), part.files.begin(), part.files.end());
  report.warnings.append(part.warnings);
}

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  const project::Project project = readProjectFor(request, AccuracyOf::both);
  const std::string folder = resultsFolder(request, project);
  KeptRun kept("run", request, project, folder, progress);
  StageReport report;
  report.warnings = project.warnings;

  // Pictures need colour, grids alone need less: one engine serves both when the project has views.
  const Engine engine(project, !project.views.empty());
  const project::Results results = calculateGrids(project, engine, kept.progress(), {}, kept.keeping());
  report.files = writeResults(project, results, folder);
  const std::string planFile = (fs::path(folder) / "plan.json").string();
  core::writeFile(planFile, core::toJson(planDocument(project, engine)));
  report.files.push_back(planFile);
  report.json = project::toJson(results);
  report.text = resultsText(results);
  report.verdictFailed = anyFailed(results);

  if (!project.grids.empty() && !progress.cancelled()) {
    StageRequest plot;
    plot.inputs = {folder};
    append(report, plotStage().run(plot, kept.progress()));
  }
  core::Value views;
  bool isFinished = results.reached || !project.settings.timeLimit_s;
  RenderOptions options;
  options.keeping = kept.keeping();
  for (const scene::View& view : project.views) {
    if (progress.cancelled()) break;
    const double limit = project.settings.timeLimit_s
                             ? *project.settings.timeLimit_s / static_cast<double>(project.views.size())
                             : std::numeric_limits<double>::infinity();
    const RenderedView done = renderToFile(project, engine, view, folder, limit, kept.progress(), {}, options);
    isFinished = isFinished && (done.reached || !project.settings.timeLimit_s);
    report.files.push_back(done.file);
    report.text += renderText(done, project);
    views.push(toJson(done, engine));
    StageRequest display;
    display.inputs = {done.file};
    display.common.output = fs::path(done.file).replace_extension(".png").string();
    append(report, displayStage().run(display, kept.progress()));
  }
  if (!views.isNull()) report.json.set("views", std::move(views));
  report.text += fmt::format("results are in {}\n", folder);
  report.unfinished = progress.cancelled();
  kept.close(report, isFinished && !report.unfinished);
  return report;
}

}  // namespace

Stage runStage() {
  Stage stage;
  stage.name = "run";
  stage.title = "Do everything: grids, plots, renderings, pictures";
  stage.help =
      "The main job: calculates the grids, plots them, renders the views and turns them into pictures, all into one "
      "folder.";
  stage.inputName = "PROJECT";
  stage.options = {resumeOption()};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
