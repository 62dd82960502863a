// The section "scenes" of a project: lighting scenes, and their effect on the luminaires.
#pragma once

#include <string>
#include <vector>

#include "core/document.h"
#include "project/project.h"
#include "project/reading.h"

namespace goniolux::project {

/// `luminaires` tell which groups there are.
std::vector<LightingScene> readLightingScenes(const core::Value& section,
                                              const std::vector<scene::Luminaire>& luminaires, Reading& reading);

/// Multiplies each luminaire's dimming by its group's factor; a group that the scene does not list is off.
void applyLightingScene(const std::string& name, const std::vector<LightingScene>& scenes,
                        std::vector<scene::Luminaire>& luminaires, Reading& reading);

}  // namespace goniolux::project
