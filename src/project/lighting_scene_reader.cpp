#include "project/lighting_scene_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/closest_name.h"
#include "project/section_reader.h"

namespace goniolux::project {

std::vector<LightingScene> readLightingScenes(const core::Value& value, const std::vector<scene::Luminaire>& luminaires,
                                              Reading& reading) {
  std::vector<LightingScene> scenes;
  if (!value.isArray()) {
    reading.error(value, "wrong-type", "\"scenes\" must be a list: \"scenes\": [ { … }, … ]");
    return scenes;
  }
  std::vector<std::string> known;
  for (const scene::Luminaire& luminaire : luminaires) {
    if (std::find(known.begin(), known.end(), luminaire.group) == known.end()) known.push_back(luminaire.group);
  }
  for (const core::Value& entry : value.array()) {
    SectionReader section(entry, lightingSceneSection(), reading);
    if (!section.isObject()) continue;
    LightingScene scene;
    scene.name = section.text("name").value_or("");
    const core::Value* groups = section.find("groups");
    if (groups && !groups->isObject()) {
      section.refuse("groups", "wrong-type", "\"groups\" must be an object: { \"group\": factor, … }");
    } else if (groups) {
      const Key factor{.name = "dimming factor", .minimum = 0};
      for (const auto& [group, dimming] : groups->object()) {
        if (const auto number = readNumber(dimming, factor, reading)) scene.groups[group] = *number;
        if (std::find(known.begin(), known.end(), group) != known.end()) continue;
        reading.diagnostics.error(
            dimming.keyPosition(), "unknown-name",
            fmt::format("no luminaire belongs to the group \"{}\"{}", group, core::suggestion(group, known)));
      }
    }
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

void applyLightingScene(const std::string& name, const std::vector<LightingScene>& scenes,
                        std::vector<scene::Luminaire>& luminaires, Reading& reading) {
  const auto scene =
      std::find_if(scenes.begin(), scenes.end(), [&](const LightingScene& each) { return each.name == name; });
  if (scene == scenes.end()) {
    std::vector<std::string> known;
    for (const LightingScene& each : scenes) known.push_back(each.name);
    reading.diagnostics.error(
        {"--scene " + name, 0, 0}, "unknown-name",
        fmt::format("the project has no lighting scene \"{}\"{}", name, core::suggestion(name, known)));
    return;
  }
  for (scene::Luminaire& luminaire : luminaires) {
    const auto factor = scene->groups.find(luminaire.group);
    luminaire.dimming *= factor == scene->groups.end() ? 0 : factor->second;
  }
}

}  // namespace goniolux::project
