// The stage `scenes`: the grids of every lighting scene of a project, from one calculation per group of luminaires that
// is kept beside the results.
#include <fmt/format.h>

#include <filesystem>

#include "core/document.h"
#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "pipeline/kept_run.h"
#include "pipeline/kept_wavelengths.h"
#include "pipeline/outline.h"
#include "pipeline/requirements.h"
#include "pipeline/result_files.h"
#include "pipeline/scene_groups.h"
#include "pipeline/stages.h"
#include "pipeline/text_option.h"

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

enum class Keep { levels, spectra };

Keep keepOf(const StageRequest& request) {
  const auto found = request.options.find("keep");
  if (found == request.options.end() || found->second == "levels") return Keep::levels;
  if (found->second == "spectra") return Keep::spectra;
  throw core::InputError({}, "bad-option", fmt::format("--keep {}: take levels or spectra", found->second));
}

// The groups' results, from what was kept or calculated now.
class Groups {
 public:
  Groups(const project::Project& project, std::string folder, core::ProgressSink& progress, StageReport& report,
         core::Keeping keeping)
      : project_(project),
        folder_(std::move(folder)),
        progress_(progress),
        report_(report),
        keeping_(std::move(keeping)) {
    fs::create_directories(folder_);
  }

  /// For dimming: as the lamps' spectra are now. False when interrupted.
  bool forLevels() {
    const std::string key = groupKey(project_);
    for (const std::string& group : groupsOf(project_)) {
      auto found = keptOrCalculated(onlyGroup(project_, group), key, group, project::fileNameFor(group));
      if (!found) return false;
      results[group] = std::move(*found);
    }
    return true;
  }

  /// For dimming and other lamps: a calculation per group and wavelength, weighted by the lamps' spectra.
  bool forSpectra(const KeptWavelengths& light) {
    const std::string key = groupKey(project_, LampSpectra::doNotMatter);
    for (const std::string& group : groupsOf(project_)) {
      const spectrum::SpectralDistribution lamp = lampSpectrumOf(project_, group);
      std::vector<Results> all;
      for (const double wavelength : light.wavelengths()) {
        const std::string name = fmt::format("{} at {:g} nm", group, wavelength);
        const std::string file = fmt::format("{}-{:g}nm", project::fileNameFor(group), wavelength);
        auto found = keptOrCalculated(atWavelength(onlyGroup(project_, group), wavelength), key, name, file);
        if (!found) return false;
        all.push_back(std::move(*found));
      }
      results[group] = light.of(lamp, all, project_);
      if (light.wavelengths().size() > 1)
        leftOut.push_back(fmt::format(
            "wavelengths between the {} kept of group \"{}\": at most {:.2g} % of E with its lamp's spectrum",
            light.wavelengths().size(), group, 100 * light.with(lamp).error.illuminance));
    }
    return true;
  }

  std::map<std::string, Results> results;
  std::vector<std::string> leftOut;
  std::size_t traced = 0, reused = 0;

 private:
  std::optional<Results> keptOrCalculated(const project::Project& alone, const std::string& key,
                                          const std::string& name, const std::string& file) {
    const std::string path = (fs::path(folder_) / (file + ".json")).string();
    if (auto found = kept(path, key, name)) {
      ++reused;
      return found;
    }
    progress_.note(fmt::format("group \"{}\" is calculated", name));
    Results calculated = calculateGrids(alone, Engine(alone, false), progress_, {}, keeping_.part("group " + name));
    calculated.projectHash = key;
    calculated.lightingScene = name;
    ++traced;
    if (progress_.cancelled()) return std::nullopt;
    core::writeFile(path, core::toJson(project::toJson(calculated)));
    report_.files.push_back(path);
    return calculated;
  }

  const project::Project& project_;
  std::string folder_;
  core::ProgressSink& progress_;
  StageReport& report_;
  core::Keeping keeping_;
};

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  const Keep keep = keepOf(request);
  const project::Project project = readProjectFor(request, AccuracyOf::grids);
  const std::map<std::string, double> dimming = dimmingOf(project);
  const std::string folder = resultsFolder(request, project);

  StageReport report;
  report.warnings = project.warnings;
  KeptRun keptRun("scenes", request, project, folder, progress);
  Groups groups(project, (fs::path(folder) / "groups").string(), keptRun.progress(), report, keptRun.keeping());
  const bool whole = keep == Keep::spectra
                         ? groups.forSpectra(KeptWavelengths(project, scene::buildWorld(project.environment)))
                         : groups.forLevels();
  if (!whole) {
    report.unfinished = true;
    keptRun.close(report, false);
    return report;
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
  report.text = fmt::format("{}: {} groups{}, {} calculated now, {} kept\n", project.name, groups.results.size(),
                            keep == Keep::spectra ? " by wavelengths" : "", groups.traced, groups.reused);
  for (const auto& [name, levels] : scenes) {
    Results results = superposed(groups.results, levels);
    results.lightingScene = name;
    results.projectHash = project.hash;
    results.inputs = project.inputs;
    results.requirements = judge(project, results);
    results.leftOut.insert(results.leftOut.end(), groups.leftOut.begin(), groups.leftOut.end());
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
  report.json.set("groups_calculated", static_cast<double>(groups.traced));
  report.json.set("groups_kept", static_cast<double>(groups.reused));
  report.json.set("scenes", documents);
  keptRun.close(report, true);
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
      "levels or scenes nothing is traced anew; with --keep spectra nothing is after a change of lamp spectra either. "
      "Scenes go to scenes/NAME.";
  stage.inputName = "PROJECT";
  stage.options = {textOption("keep", "for what changes the groups are kept", "levels",
                              "levels: dimming; spectra: dimming and lamp spectra, from one calculation per group and "
                              "wavelength (where finishes are coloured: some ten times the work, once)",
                              false),
                   resumeOption()};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
