#include "pipeline/lighting_power.h"

#include "pipeline/report_input.h"

namespace goniolux::pipeline {
namespace {

core::Estimate scaled(core::Estimate e, double factor) {
  e.value *= factor;
  e.statistical *= factor;
  for (auto& [cause, bound] : e.systematic) bound *= factor;
  return e;
}

}  // namespace

void addLightingPower(const project::Project& project, const Engine& engine, project::Results& results) {
  project::LightingPower power;
  for (const scene::LightSource& source : engine.world.emitters) power.flux_lm += source.emitter->flux();
  const auto& luminaires = project.environment.luminaires;
  double watts = 0;
  bool isKnown = !luminaires.empty();
  for (const scene::Luminaire& luminaire : luminaires) {
    watts += luminaire.watts;
    isKnown = isKnown && luminaire.watts > 0;
  }
  if (isKnown) power.connectedLoad_W = watts;
  power.floorArea_m2 = floorArea(project);
  if (isKnown && power.floorArea_m2 && *power.floorArea_m2 > 0)
    power.density_W_m2 = core::Estimate{watts / *power.floorArea_m2, 0, {}};

  for (project::GridResult& grid : results.grids) {
    if (grid.quantity != "illuminance" || !grid.plane || !(power.flux_lm > 0)) continue;
    // CIE S 017, utilance: flux received by a reference surface over the flux that leaves the luminaires. Points inside
    // objects are no part of the surface.
    const double free = 1 - static_cast<double>(grid.excluded.size()) / static_cast<double>(grid.points.size());
    const double area = glm::length(glm::cross(grid.plane->u, grid.plane->v)) * free;
    grid.utilance = scaled(grid.mean, area / power.flux_lm);
    if (!power.density_W_m2 || !(grid.mean.value > 0)) continue;
    // x = 100 d / E: its half-width is that share of it that E's is of E.
    const double perLux = 100 * power.density_W_m2->value / grid.mean.value;
    grid.powerPer100lx = scaled(grid.mean, perLux / grid.mean.value);
  }
  results.power = power;
}

}  // namespace goniolux::pipeline
