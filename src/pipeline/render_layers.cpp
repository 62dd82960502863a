#include "pipeline/render_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include "core/sha256.h"
#include "image/mix.h"
#include "pipeline/scene_groups.h"
#include "project/results.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* keyAttribute = "layerKey";

// Identifies what a layer depends on beside its group and view.
std::string layerKey(const project::Project& project, const RenderOptions& options) {
  const auto& settings = project.settings;
  std::string text =
      groupKey(project) + fmt::format(" {} {} {} {} {} {} {}", settings.accuracy.image, settings.pixelMaxSamples,
                                      settings.pixelMinSamples, settings.pixelContrast, settings.pixelFilter,
                                      static_cast<int>(options.form), options.parts);
  if (options.channels)
    text += fmt::format(" {} {} {}", options.channels->from_nm, options.channels->to_nm, options.channels->step_nm);
  return core::sha256(text);
}

std::optional<image::XyzImage> kept(const std::string& path, const std::string& key) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  try {
    image::XyzImage image = image::readExr(path);
    const auto found = image.attributes.find(keyAttribute);
    if (found != image.attributes.end() && found->second == key) return image;
  } catch (const core::InputError&) {  // damaged: rendered anew
  }
  return std::nullopt;
}

}  // namespace

StageReport renderLayers(const project::Project& project, const std::vector<const scene::View*>& views,
                         const std::string& folder, const RenderOptions& options, core::ProgressSink& progress) {
  const std::map<std::string, double> dimming = dimmingOf(project);
  const std::vector<std::string> layers = groupsOf(project);
  const std::string key = layerKey(project, options);
  StageReport report;
  report.warnings = project.warnings;
  std::map<std::string, std::map<std::string, image::XyzImage>> images;  // view, layer
  std::size_t traced = 0;
  core::Value list;
  for (const std::string& layer : layers) {
    const std::string layerFolder = (fs::path(folder) / "layers" / project::fileNameFor(layer)).string();
    std::vector<const scene::View*> missing;
    for (const scene::View* view : views) {
      auto image = kept((fs::path(layerFolder) / imageFileName(*view)).string(), key);
      if (image)
        images[view->name][layer] = std::move(*image);
      else
        missing.push_back(view);
    }
    if (missing.empty()) continue;
    progress.note(fmt::format("layer \"{}\" is rendered", layer));
    const project::Project alone = onlyGroup(project, layer);
    const Engine engine(alone, true);
    RenderOptions own = options;
    own.keeping = options.keeping.part("layer " + layer);
    own.attributes[keyAttribute] = key;
    own.attributes["layer"] = layer;
    const double parts = static_cast<double>(layers.size() * views.size());
    const double limit = project.settings.timeLimit_s.value_or(std::numeric_limits<double>::infinity()) / parts;
    for (const scene::View* view : missing) {
      const RenderedView done = renderToFile(alone, engine, *view, layerFolder, limit, progress, {}, own);
      if (progress.cancelled()) {
        report.unfinished = true;
        return report;
      }
      ++traced;
      report.files.push_back(done.file);
      report.text += renderText(done, project);
      images[view->name][layer] = image::readExr(done.file);
    }
  }
  for (const scene::View* view : views) {
    std::vector<image::MixPart> parts;
    core::Value levels;
    std::string recipe;
    for (const std::string& layer : layers) {
      const auto found = dimming.find(layer);
      const double level = found != dimming.end() ? found->second : 1;
      parts.push_back({&images[view->name][layer], level});
      levels.set(layer, level);
      recipe += fmt::format("{}{:g} {}", recipe.empty() ? "" : " + ", level, layer);
    }
    image::XyzImage sum = image::mixed(parts);
    sum.attributes["seed"] = std::to_string(project.settings.seed);
    sum.attributes["mixedFrom"] = recipe;
    const std::string file = (fs::path(folder) / imageFileName(*view)).string();
    image::writeExr(file, sum, options.form);
    report.files.push_back(file);
    report.text += fmt::format("  view {}: {}\n    {}\n", view->name, recipe, file);
    core::Value json;
    json.set("view", view->name);
    json.set("file", file);
    json.set("levels", std::move(levels));
    list.push(std::move(json));
  }
  report.json.set("layers_rendered", static_cast<double>(traced));
  report.json.set("layers_kept", static_cast<double>(layers.size() * views.size() - traced));
  report.json.set("views", std::move(list));
  return report;
}

}  // namespace goniolux::pipeline
