// The stage `study`: what is asked for, and what is written.
#include "pipeline/study.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "core/text.h"
#include "pipeline/batch.h"
#include "pipeline/engine.h"
#include "pipeline/plot.h"
#include "pipeline/stages.h"
#include "pipeline/study_choices.h"
#include "pipeline/text_option.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr double suiteTime_s = 1080;  // of all projects together: with charts and pages under twenty minutes

void draw(const std::string& folder, const std::string& name, const plot::LineChart& chart, StageReport& report) {
  const std::string stem = (fs::path(folder) / name).string(), figure = stem + ".figure.json";
  core::writeFile(figure, core::toJson(plot::toJson(chart)));
  if (const std::string trouble = drawFigure(figure, {stem + ".png", stem + ".svg"}); !trouble.empty()) {
    report.warnings.warning({}, "cannot-draw",
                            fmt::format("drawing is not possible here: {}; the numbers are in {}", trouble, figure));
    return;
  }
  report.files.insert(report.files.end(), {stem + ".png", stem + ".svg"});
}

void writeStudy(const ProjectStudy& study, const std::string& folder, StageReport& report) {
  const std::string csv = (fs::path(folder) / "study.csv").string();
  core::writeFile(csv, studyCsv(study));
  report.files.push_back(csv);
  if (!study.grids.empty()) {
    StudyChartText text{study.name, "points of the grids", study.reference->noise, 0};
    for (const auto& grid : study.reference->results.grids) text.count += grid.points.size();
    draw(folder, "work-precision", workPrecisionChart(text, study.grids), report);
  }
  if (!study.picture.empty()) {
    const scene::View& view = study.pictureReference->view;
    const StudyChartText text{study.name, fmt::format("pixels of the view “{}”", view.name),
                              study.pictureReference->noise,
                              static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height)};
    draw(folder, "picture-precision", workPrecisionChart(text, study.picture), report);
  }
}

std::string choiceText(const std::string& project, const ChoiceStudy& choice, const ChoiceResult& result) {
  std::string text = fmt::format("{}: {}\n", project, choice.title);
  std::vector<std::size_t> widths;
  for (const std::string& column : result.columns) widths.push_back(column.size() + 2);
  for (const auto& row : result.rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size() + 2);
  const auto line = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) text += fmt::format("{:>{}}", cells[i], widths[i]);
    text += "\n";
  };
  line(result.columns);
  for (const auto& row : result.rows) line(row);
  for (const std::string& fact : result.chart.facts) text += "  " + fact + "\n";
  return text;
}

/// A study of one choice, of each project.
StageReport studyOf(const ChoiceStudy& choice, const StageRequest& request, core::ProgressSink& progress) {
  StageReport report;
  const std::vector<std::string> paths = findProjects(request.inputs);
  for (const std::string& path : paths) {
    StageRequest one = request;
    one.inputs = {path};
    const project::Project project = readProjectFor(one, AccuracyOf::grids);
    report.warnings.append(project.warnings);
    const std::string folder =
        paths.size() == 1 ? request.common.output.value_or((fs::path(project.folder) / "study").string())
                          : (fs::path(request.common.output.value_or("study")) / project::fileNameFor(path)).string();
    const ChoiceResult result = choice.run(project, progress);
    report.unfinished = progress.cancelled();
    if (report.unfinished) return report;
    fs::create_directories(folder);
    const std::string csv = (fs::path(folder) / (choice.name + ".csv")).string();
    std::string text = fmt::format("{}\n", fmt::join(result.columns, ","));
    core::Value rows = core::Value::Array{};
    for (const auto& row : result.rows) {
      text += fmt::format("{}\n", fmt::join(row, ","));
      core::Value entry;
      for (std::size_t i = 0; i < row.size(); ++i) entry.set(result.columns[i], row[i]);
      rows.push(std::move(entry));
    }
    core::writeFile(csv, text);
    report.files.push_back(csv);
    draw(folder, choice.name, result.chart, report);
    report.text += choiceText(project.name, choice, result);
    report.json.set("path", path);
    report.json.set("project", project.name);
    report.json.set("of", choice.name);
    report.json.set("rows", std::move(rows));
  }
  return report;
}

/// Seconds of --reference.
std::optional<double> referenceSeconds(const StageRequest& request) {
  const auto given = request.options.find("reference");
  if (given == request.options.end()) return std::nullopt;
  const auto seconds = core::parseNumber(given->second);
  if (!seconds || !(*seconds > 0) || !std::isfinite(*seconds))
    throw core::InputError({"--reference", 0, 0}, "seconds",
                           fmt::format("'{}' is no time; give seconds above 0", given->second));
  return seconds;
}

StageReport study(const StageRequest& request, core::ProgressSink& progress) {
  if (const auto of = request.options.find("of"); of != request.options.end()) {
    if (const ChoiceStudy* choice = findChoiceStudy(of->second)) return studyOf(*choice, request, progress);
    std::vector<std::string> names;
    for (const ChoiceStudy& each : choiceStudies()) names.push_back(each.name);
    throw core::InputError(
        {}, "unknown-study",
        fmt::format("there is no study of \"{}\"; there are {}", of->second, fmt::join(names, ", ")));
  }
  const bool suite = request.options.contains("suite");
  const std::vector<std::string> paths = findProjects(request.inputs);
  const bool several = suite || paths.size() > 1;
  StudyTime time;
  time.time_s = request.common.timeLimit_s.value_or(suite ? suiteTime_s : time.time_s);
  const double whole = time.time_s;  // of a suite
  time.reference_s = referenceSeconds(request);
  StageReport report;
  std::vector<ProjectStudy> studies;
  double spent = 0;
  core::Value all = core::Value::Array{};
  for (std::size_t i = 0; i < paths.size() && !progress.cancelled(); ++i) {
    const std::string& path = paths[i];
    StageRequest one = request;
    one.inputs = {path};
    // What a quick project leaves is for those after it.
    if (suite) time.time_s = std::max(0.0, whole - spent) / static_cast<double>(paths.size() - i);
    time.from = static_cast<double>(i) / static_cast<double>(paths.size());
    time.to = static_cast<double>(i + 1) / static_cast<double>(paths.size());
    try {
      const project::Project project = readProjectFor(one, AccuracyOf::grids);
      report.warnings.append(project.warnings);
      const std::string folder =
          several ? (fs::path(request.common.output.value_or("study")) / project::fileNameFor(path)).string()
                  : request.common.output.value_or((fs::path(project.folder) / "study").string());
      studies.push_back(makeStudy(project, request.common.scene.value_or(""), folder, time, progress, report.warnings));
      studies.back().path = path;
      spent += studies.back().spent_s;
      writeStudy(studies.back(), folder, report);
      report.text += studyText(studies.back());
    } catch (const core::InputError& error) {
      if (!several) throw;
      ProjectStudy broken;
      broken.path = broken.name = path;
      broken.trouble = error.what();
      report.text += fmt::format("{}: {}\n", path, broken.trouble);
      report.inputFailed = true;
      studies.push_back(std::move(broken));
    }
    all.push(toJson(studies.back()));
  }
  if (several) {
    const std::string page = (fs::path(request.common.output.value_or("study")) / "README.md").string();
    core::writeFile(page, studyPage(studies, suite ? whole / static_cast<double>(paths.size()) : whole));
    report.files.push_back(page);
    report.json.set("projects", std::move(all));
  } else {
    report.json = all.array().empty() ? core::Value() : all.array().front();
  }
  report.unfinished = progress.cancelled();
  if (report.unfinished) report.text += "  stopped; the same command goes on from here\n";
  return report;
}

}  // namespace

Stage studyStage() {
  Stage stage;
  stage.name = "study";
  stage.title = "Chart speed against accuracy";
  stage.help =
      "Calculates the grids, and the first view as a small picture, by every solver and a ladder of settings: "
      "accuracy, "
      "wavelengths, luminaires cut into points, depth and cut-off of trees, samples of a pixel. Each run is held "
      "against a "
      "long unbiased reference that it makes first: study.csv and the work-precision charts, with the front, the "
      "plateaus "
      "of biased methods and what `auto` chooses. Where two independent solvers disagree, cross.json and a picture "
      "name "
      "the places. Goes on where it was stopped; --time-limit is for each project, 120 s if not given. -o: folder, "
      "PROJECT/study if not given. With several projects, or folders of projects, a page README.md shows them all. "
      "With "
      "--of only one thing is varied:";
  for (const ChoiceStudy& choice : choiceStudies()) stage.help += fmt::format(" {} ({});", choice.name, choice.help);
  stage.help.back() = '.';
  stage.inputName = "PROJECT";
  stage.manyInputs = true;
  core::Parameter of =
      textOption("of", "a single choice", "", "draws what one choice costs or spoils: see above", false);
  core::Parameter reference =
      textOption("reference", "time of the references", "",
                 "seconds for a project's references, which then do not count in the time limit", false);
  core::Parameter whole =
      textOption("suite", "all projects in one time", "",
                 "--time-limit (1080 s if not given) is for all projects together; makes the page", false);
  whole.kind = core::ParameterKind::boolean;
  stage.options = {of, reference, whole};
  stage.run = study;
  return stage;
}

}  // namespace goniolux::pipeline
