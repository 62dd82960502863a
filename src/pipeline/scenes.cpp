// The stage `scenes`: the grids of every lighting scene of a project, from one calculation per group of luminaires that
// is kept beside the results.
#include <fmt/format.h>

#include <filesystem>

#include "core/document.h"
#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "pipeline/outline.h"
#include "pipeline/requirements.h"
#include "pipeline/result_files.h"
#include "pipeline/scene_groups.h"
#include "pipeline/stages.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using core::Value;
using project::Results;

// A group's results are the document of `illuminate`: its hash is the group key, its scene the group's name.
std::optional<Results> kept(const std::string& path, const std::string& key, const std::string& group) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  try {
    Results results = project::readResults(path);
    if (results.projectHash == key && results.lightingScene == group) return results;
  } catch (const core::InputError&) {  // damaged: calculated anew
  }
  return std::nullopt;
}

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  const project::Project project = readProjectFor(request, AccuracyOf::grids);
  const std::map<std::string, double> dimming = dimmingOf(project);
  const std::string folder = resultsFolder(request, project), groupFolder = (fs::path(folder) / "groups").string();
  const std::string key = groupKey(project);
  fs::create_directories(groupFolder);

  StageReport report;
  report.warnings = project.warnings;
  std::map<std::string, Results> groups;
  std::size_t traced = 0;
  for (const std::string& group : groupsOf(project)) {
    const std::string path = (fs::path(groupFolder) / (project::fileNameFor(group) + ".json")).string();
    if (auto results = kept(path, key, group)) {
      groups[group] = std::move(*results);
      continue;
    }
    progress.note(fmt::format("group \"{}\" is calculated", group));
    const project::Project alone = onlyGroup(project, group);
    Results results = calculateGrids(alone, Engine(alone, false), progress);
    results.projectHash = key;
    results.lightingScene = group;
    ++traced;
    if (progress.cancelled()) {
      report.unfinished = true;
      return report;
    }
    core::writeFile(path, core::toJson(project::toJson(results)));
    report.files.push_back(path);
    groups[group] = std::move(results);
  }

  // The project as it stands, then its scenes.
  std::vector<std::pair<std::string, std::map<std::string, double>>> scenes{{"", dimming}};
  scenes.front().second.try_emplace(emittingSurfaces, 1.0);
  for (const project::LightingScene& scene : project.scenes) {
    std::map<std::string, double> levels;
    for (const auto& [group, level] : scene.groups) levels[group] = level * dimming.at(group);
    levels.try_emplace(emittingSurfaces, 1.0);
    scenes.emplace_back(scene.name, levels);
  }
  Value::Array documents;
  report.text = fmt::format("{}: {} groups, {} calculated now, {} kept\n", project.name, groups.size(), traced,
                            groups.size() - traced);
  for (const auto& [name, levels] : scenes) {
    Results results = superposed(groups, levels);
    results.lightingScene = name;
    results.projectHash = project.hash;
    results.inputs = project.inputs;
    results.requirements = judge(project, results);
    if (!project.observers.empty())
      results.leftOut.emplace_back(
          "glare ratings: they do not add up over groups; calculate a scene by "
          "illuminate --scene");
    if (name.empty()) report.verdictFailed = anyFailed(results);
    const std::string target =
        name.empty() ? folder : (fs::path(folder) / "scenes" / project::fileNameFor(name)).string();
    const auto files = writeResultFiles(target, results, outlineOf(project));
    report.files.insert(report.files.end(), files.begin(), files.end());
    documents.push_back(project::toJson(results));
    report.text += fmt::format("scene {}\n", name.empty() ? "as the project states its dimming" : "\"" + name + "\"");
    for (const project::GridResult& grid : results.grids)
      report.text += fmt::format("    {:<20} mean {:>9.4g} ± {:.2g} {}, minimum {:.4g} ± {:.2g}, U0 {:.3f} ± {:.2g}\n",
                                 grid.name, grid.mean.value, grid.mean.halfWidth(), grid.unit, grid.min.value,
                                 grid.min.halfWidth(), grid.u0.value, grid.u0.halfWidth());
  }
  report.json.set("groups_calculated", static_cast<double>(traced));
  report.json.set("groups_kept", static_cast<double>(groups.size() - traced));
  report.json.set("scenes", documents);
  return report;
}

}  // namespace

Stage scenesStage() {
  Stage stage;
  stage.name = "scenes";
  stage.title = "Calculate the grids of every lighting scene";
  stage.help =
      "Calculates the grids once for each group of luminaires alone and adds them up for the project's own dimming and "
      "for every lighting scene. What a group gives is kept in groups/ of the results folder: after a change of "
      "dimming "
      "levels or scenes nothing is traced anew. Scenes go to scenes/NAME.";
  stage.inputName = "PROJECT";
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
