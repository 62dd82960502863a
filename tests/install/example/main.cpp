// Calculates the grids of a project and prints their mean illuminance with its half-width: room_light PROJECT
#include <cstdio>

#include "core/diagnostics.h"
#include "core/progress.h"
#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "project/project.h"

int main(int argc, char** argv) {
  using namespace goniolux;
  if (argc != 2) {
    std::fprintf(stderr, "usage: room_light PROJECT\n");
    return 2;
  }
  try {
    const project::Project project = project::readProject(argv[1], {{"accuracy.grid=5 %"}, {}});
    const pipeline::Engine engine(project, false);
    core::SilentProgress progress;
    const project::Results results = pipeline::calculateGrids(project, engine, progress);
    for (const project::GridResult& grid : results.grids)
      std::printf("%s: %.1f lx, half-width %.1f lx\n", grid.name.c_str(), grid.mean.value, grid.mean.halfWidth());
  } catch (const core::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
