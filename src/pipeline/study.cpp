// The stage `study`: the ladder of settings, the reference, what is kept for the next time, and the chart.
#include "pipeline/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "analysis/grid_estimate.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/sha256.h"
#include "core/statistics.h"
#include "pipeline/batch.h"
#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "pipeline/plot.h"
#include "pipeline/stages.h"
#include "pipeline/study_choices.h"
#include "pipeline/text_option.h"
#include "project/settings_reader.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr double defaultTime_s = 120;
constexpr double suiteTime_s = 1080;  // of all projects together: with charts and pages under twenty minutes
constexpr double ladder[] = {0.1, 0.05, 0.02, 0.01, 0.005};
constexpr double referenceShare = 0.4;           // of the time
constexpr double referenceAccuracy = 0.0015;     // finer than any rung, if time allows
constexpr double coarsestReference = 0.02;       // a coarser one says nothing
constexpr double mostGrowth = 16;                // of a run's time, from one rung to the next
constexpr const char* runsFile = "study.jsonl";  // one line per run that is done

/// Everything that a kept result depends on.
std::string keyOf(const project::Project& project, const std::string& lightingScene) {
  return core::sha256(project.hash + programVersion() + lightingScene +
                      core::toJson(project::settingsDocument(project.settings)));
}

// The reference's document says `key` where results have their project's hash.
StudyReference makeReference(const project::Project& project, const std::string& key, const std::string& file,
                             double seconds, core::ProgressSink& progress) {
  StudyReference reference;
  bool known = false;
  if (fs::exists(file)) {
    try {
      reference.results = project::readResults(file);
      known = reference.results.projectHash == key && reference.results.grids.size() == project.grids.size();
    } catch (const core::InputError&) {
      known = false;  // damaged: made again
    }
  }
  if (!known) {
    project::Project own = project;
    own.settings.solver = "path";
    own.settings.seed = core::mix(project.settings.seed ^ 0x5eedull);
    own.settings.timeLimit_s = seconds;
    own.settings.accuracy.grid = referenceAccuracy;
    own.observers.clear();
    own.requirements.clear();
    const Engine engine(own, false);
    reference.results = calculateGrids(own, engine, progress);
    reference.results.projectHash = key;
    if (!progress.cancelled()) core::writeFile(file, core::toJson(project::toJson(reference.results)));
  }
  const double quantile = core::studentQuantile(analysis::replicateCount - 1, reference.results.confidence);
  double squares = 0, count = 0;
  for (const project::GridResult& grid : reference.results.grids)
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      if (!std::isfinite(grid.values[i]) || !(grid.values[i] > 0)) continue;
      const double relative = grid.halfWidths[i] / std::max(grid.values[i], 0.1 * grid.mean.value) / quantile;
      squares += relative * relative;
      ++count;
    }
  reference.noise = count > 0 ? std::sqrt(squares / count) : 0;
  return reference;
}

bool same(const StudySetting& a, const StudySetting& b) {
  return a.line == b.line && a.solver == b.solver && a.accuracy == b.accuracy && a.spectral == b.spectral;
}

std::vector<StudySetting> settingsOf(const project::Project& project, const planner::Plan& plan) {
  // First what `auto` does, then all methods of a coarse rung before any of a finer one: what is left out for want of
  // time are the finest.
  const StudySetting chosen{plan.solver, plan.solver, project.settings.accuracy.grid, "auto"};
  std::vector<StudySetting> settings{chosen};
  for (const double accuracy : ladder)
    for (const solver::SolverType& type : solver::solverTypes()) {
      if (type.name == "tree" && accuracy != ladder[1]) continue;  // its error does not depend on it
      const StudySetting setting{type.name, type.name, accuracy, "auto"};
      if (!same(setting, chosen)) settings.push_back(setting);
    }
  if (plan.quadrature.wavelengths.size() > 1)
    for (const char* scheme : {"xyz:3", "uniform:3", "uniform:9", "uniform:31"})
      settings.push_back({"wavelengths", plan.solver, 0.01, scheme});
  return settings;
}

/// Runs that are kept from a study of the same project by the same program.
std::vector<StudyRun> keptRuns(const std::string& file, const std::string& key) {
  std::vector<StudyRun> runs;
  if (!fs::exists(file)) return runs;
  const std::string text = core::readFile(file);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    core::Diagnostics ignored;
    const core::Value line = core::parseJson(text.substr(begin, end - begin), file, ignored);
    begin = end + 1;
    const core::Value* of = line.isObject() ? line.find("of") : nullptr;
    if (ignored.hasErrors() || of == nullptr || !of->isString() || of->string() != key) continue;
    if (const auto run = studyRunFromJson(line)) runs.push_back(*run);
  }
  return runs;
}

std::string tableOf(const std::vector<StudyRun>& runs) {
  std::string text = fmt::format("  {:<12}{:>8}{:>12}{:>9}{:>9}{:>10}{:>9}{:>9}\n", "method", "asked", "wavelengths",
                                 "CPU s", "RMS %", "largest %", "mean %", "inside");
  for (const StudyRun& run : runs)
    text += fmt::format("{} {:<12}{:>6g} %{:>12}{:>9.3g}{:>9.3g}{:>10.3g}{:>9.2g}{:>7.1f} %\n", run.isAuto ? "*" : " ",
                        run.setting.line, 100 * run.setting.accuracy, run.setting.spectral, run.cpu_s, 100 * run.rms,
                        100 * run.largest, 100 * run.mean, 100 * run.inside);
  return text;
}

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

/// One project's study, kept in `folder`.
struct ProjectStudy {
  std::string path, name;
  std::vector<StudyRun> runs;
  StudyReference reference;
  std::string chosen;       ///< the solver that the planner takes
  std::size_t leftOut = 0;  ///< finer runs that do not fit into the time
  std::string trouble;      ///< of a project of several that cannot be studied
};

ProjectStudy studyProject(const project::Project& project, const std::string& lightingScene, const std::string& folder,
                          double time, core::ProgressSink& progress, core::Diagnostics& warnings) {
  ProjectStudy study;
  study.path = project.folder;
  study.name = project.name;
  if (project.grids.empty())
    throw core::InputError({project.file, 0, 0}, "nothing-to-study",
                           "the project has no grid: a study compares the points of grids; add one");
  const double start = core::wallSeconds();
  const auto elapsed = [&] { return core::wallSeconds() - start; };
  fs::create_directories(folder);
  const std::string kept = (fs::path(folder) / runsFile).string(), key = keyOf(project, lightingScene);
  progress.progress(project.name, 0, "reference: a long unbiased run");
  study.reference =
      makeReference(project, key, (fs::path(folder) / "reference.json").string(), referenceShare * time, progress);
  if (progress.cancelled()) return study;
  if (!(study.reference.noise < coarsestReference))
    warnings.warning({project.file, 0, 0}, "coarse-reference",
                     fmt::format("in the time given the reference is known to {:.2g} % only; give more by --time-limit",
                                 100 * study.reference.noise));

  const planner::Plan plan = Engine(project, false).plan;
  study.chosen = plan.solver;
  const std::vector<StudySetting> settings = settingsOf(project, plan);
  const std::vector<StudyRun> known = keptRuns(kept, key);
  std::string lines = fs::exists(kept) ? core::readFile(kept) : "";
  std::map<std::string, StudyRun> last;  // of each line
  for (std::size_t i = 0; i < settings.size() && !progress.cancelled(); ++i) {
    const StudySetting& setting = settings[i];
    progress.progress(project.name, static_cast<double>(i + 1) / static_cast<double>(settings.size() + 1),
                      fmt::format("{} at {:g} %", setting.line, 100 * setting.accuracy));
    const auto before =
        std::find_if(known.begin(), known.end(), [&](const StudyRun& run) { return same(run.setting, setting); });
    if (before != known.end()) {
      study.runs.push_back(*before);
      last[setting.line] = *before;
      continue;
    }
    // A finer run of the same line costs as the square of the accuracy; one that would not fit is left out.
    if (const auto coarser = last.find(setting.line); coarser != last.end()) {
      const double finer = coarser->second.setting.accuracy / setting.accuracy;
      if (coarser->second.wall_s * std::clamp(finer * finer, 1.0, mostGrowth) > time - elapsed()) {
        ++study.leftOut;
        continue;
      }
    }
    StudyRun run = runSetting(project, setting, study.reference, core::combine(project.settings.seed, i + 1), progress);
    if (progress.cancelled()) break;
    run.isAuto = i == 0;
    study.runs.push_back(run);
    last[setting.line] = run;
    core::Value line = toJson(run);
    line.set("of", key);
    std::string text = core::toJson(line);
    text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
    lines += text + "\n";
    core::writeFile(kept, lines);
  }
  return study;
}

void writeStudy(const ProjectStudy& study, const std::string& folder, StageReport& report) {
  const std::string csv = (fs::path(folder) / "study.csv").string();
  core::writeFile(csv, studyCsv(study.runs));
  report.files.push_back(csv);
  if (!study.runs.empty())
    draw(folder, "work-precision", workPrecisionChart(study.name, study.runs, study.reference), report);
}

std::string studyText(const ProjectStudy& study) {
  std::string text = fmt::format("{}: reference by paths, its own noise {:.2g} %\n{}", study.name,
                                 100 * study.reference.noise, tableOf(study.runs));
  text += "  front (nothing is both faster and nearer):";
  for (const StudyRun* run : paretoFront(study.runs))
    text += fmt::format(" {} {:g} %,", run->setting.line, 100 * run->setting.accuracy);
  text.back() = '\n';
  if (study.leftOut > 0)
    text += fmt::format("  {} finer runs left out: they do not fit into the time (--time-limit)\n", study.leftOut);
  return text;
}

core::Value studyJson(const ProjectStudy& study) {
  core::Value list = core::Value::Array{}, json;
  for (const StudyRun& run : study.runs) list.push(toJson(run));
  json.set("path", study.path);
  json.set("project", study.name);
  json.set("reference_noise", study.reference.noise);
  json.set("auto", study.chosen);
  json.set("runs", std::move(list));
  if (!study.trouble.empty()) json.set("trouble", study.trouble);
  return json;
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
  double time = request.common.timeLimit_s.value_or(suite ? suiteTime_s : defaultTime_s);
  if (suite) time /= static_cast<double>(paths.size());
  StageReport report;
  std::vector<ProjectStudy> studies;
  core::Value all = core::Value::Array{};
  for (const std::string& path : paths) {
    if (progress.cancelled()) break;
    StageRequest one = request;
    one.inputs = {path};
    const std::string name = project::fileNameFor(path);
    try {
      const project::Project project = readProjectFor(one, AccuracyOf::grids);
      report.warnings.append(project.warnings);
      const std::string folder = several
                                     ? (fs::path(request.common.output.value_or("study")) / name).string()
                                     : request.common.output.value_or((fs::path(project.folder) / "study").string());
      studies.push_back(
          studyProject(project, request.common.scene.value_or(""), folder, time, progress, report.warnings));
      studies.back().path = path;
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
    all.push(studyJson(studies.back()));
  }
  if (several) {
    const std::string page = (fs::path(request.common.output.value_or("study")) / "README.md").string();
    std::vector<StudyPageEntry> entries;
    for (const ProjectStudy& each : studies)
      entries.push_back({each.path, each.name, project::fileNameFor(each.path), each.trouble, each.chosen, &each.runs,
                         each.reference.noise, each.leftOut});
    core::writeFile(page, studyPage(entries, time));
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
      "Calculates the grids by every solver and at several accuracies (and with fewer wavelengths where there is "
      "colour), and holds each run against a long unbiased reference that it makes first: study.csv and the "
      "work-precision chart, the settings that `auto` chooses marked. Goes on where it was stopped; --time-limit is "
      "for each project, 120 s if not given. -o: folder, PROJECT/study if not given. With several projects, or folders "
      "of projects, a page README.md shows them all. With --of only one thing is varied:";
  for (const ChoiceStudy& choice : choiceStudies()) stage.help += fmt::format(" {} ({});", choice.name, choice.help);
  stage.help.back() = '.';
  stage.inputName = "PROJECT";
  stage.manyInputs = true;
  core::Parameter of =
      textOption("of", "a single choice", "", "draws what one choice costs or spoils: see above", false);
  core::Parameter whole =
      textOption("suite", "all projects in one time", "",
                 "--time-limit (1080 s if not given) is for all projects together; makes the page", false);
  whole.kind = core::ParameterKind::boolean;
  stage.options = {of, whole};
  stage.run = study;
  return stage;
}

}  // namespace goniolux::pipeline
