// Lighting power: how much light and load an installation has, and what of the light arrives on a plane.
#pragma once

#include "pipeline/engine.h"
#include "project/results.h"

namespace goniolux::pipeline {

/// Adds Results::power and, to regular grids of the illuminance, their utilance and the power density for 100 lx.
void addLightingPower(const project::Project& project, const Engine& engine, project::Results& results);

}  // namespace goniolux::pipeline
