// What the report takes from other verbs' files: contributions of groups (`scenes`) and the speed chart (`study`).
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/document.h"
#include "pipeline/report_input.h"
#include "pipeline/scene_groups.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

/// Levels of the groups in these results: of the project's own dimming, or of the lighting scene.
std::map<std::string, double> levelsOf(const project::Results& results, const project::Project& project) {
  std::map<std::string, double> levels = dimmingOf(project);
  if (!results.lightingScene.empty()) {
    std::map<std::string, double> ofScene;
    for (const project::LightingScene& scene : project.scenes)
      if (scene.name == results.lightingScene)
        for (const auto& [group, level] : scene.groups) ofScene[group] = level * levels[group];
    levels = ofScene;
  }
  levels.try_emplace(emittingSurfaces, 1.0);
  return levels;
}

/// groups/ stands in the results folder, or above scenes/NAME/.
std::optional<fs::path> groupsFolder(const fs::path& results) {
  std::error_code ignored;
  for (const fs::path& folder : {results / "groups", fs::absolute(results).parent_path().parent_path() / "groups"})
    if (fs::is_directory(folder, ignored)) return folder;
  return std::nullopt;
}

core::Estimate scaled(core::Estimate e, double factor) {
  e.value *= factor;
  e.statistical *= factor;
  for (auto& [cause, bound] : e.systematic) bound *= factor;
  return e;
}

bool haveTheSameGrids(const project::Results& a, const project::Results& b) {
  return std::equal(a.grids.begin(), a.grids.end(), b.grids.begin(), b.grids.end(), [](const auto& g, const auto& h) {
    return g.name == h.name && g.quantity == h.quantity && g.points.size() == h.points.size();
  });
}

/// Light adds up: what does not, within the half-widths, was kept for another form of the project.
bool addUpTo(const project::Results& results, const std::vector<report::Contribution>& contributions) {
  for (std::size_t i = 0; i < results.grids.size(); ++i) {
    double sum = 0, halfWidth = results.grids[i].mean.halfWidth();
    for (const report::Contribution& c : contributions) {
      sum += c.means[i].value;
      halfWidth += c.means[i].halfWidth();
    }
    if (!(std::abs(sum - results.grids[i].mean.value) <= halfWidth)) return false;
  }
  return true;
}

}  // namespace

std::vector<report::Contribution> contributionsOf(const project::Results& results, const project::Project& project,
                                                  const std::string& resultsFolder) {
  const std::vector<std::string> groups = groupsOf(project);
  const std::optional<fs::path> folder = groupsFolder(resultsFolder);
  if (groups.size() < 2 || !folder) return {};  // one group gives everything
  try {
    const std::map<std::string, double> levels = levelsOf(results, project);
    std::vector<report::Contribution> contributions;
    for (const std::string& group : groups) {
      const auto level = levels.find(group);
      if (level == levels.end()) continue;  // off in this lighting scene
      const project::Results alone = project::readResults((*folder / (project::fileNameFor(group) + ".json")).string());
      if (alone.lightingScene != group || !haveTheSameGrids(alone, results)) return {};
      report::Contribution contribution{group, level->second, {}};
      for (const project::GridResult& grid : alone.grids)
        contribution.means.push_back(scaled(grid.mean, level->second));
      contributions.push_back(std::move(contribution));
    }
    return addUpTo(results, contributions) ? contributions : std::vector<report::Contribution>{};
  } catch (const core::InputError&) {  // a group's file is missing or damaged, or a group has no one level
    return {};
  }
}

std::optional<report::Picture> speedChartOf(const project::Project& project) {
  const fs::path folder = fs::path(project.folder) / "study", file = folder / "work-precision.svg",
                 runs = folder / "study.jsonl";
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored) || !fs::is_regular_file(runs, ignored)) return std::nullopt;
  // A chart of the project as it was before it was changed would mislead.
  if (core::readFile(runs.string()).find(project.hash) == std::string::npos) return std::nullopt;
  return report::Picture{"work-precision", "image/svg+xml", core::readFile(file.string())};
}

}  // namespace goniolux::pipeline
