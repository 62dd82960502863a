// Small rooms as project text, and their results by a solver.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/progress.h"
#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "solver/solver.h"

namespace goniolux::stability {

/// What a project is made of: JSON texts of the list entries.
struct RoomText {
  std::vector<std::string> objects, luminaires, grids;
  std::string materials =
      R"("grey": { "model": "lambert", "diffuse": 0.5 }, "white": { "model": "lambert", "diffuse": 0.8 },
         "black": { "model": "lambert", "diffuse": 0 }, "mirror": { "model": "mirror", "reflectance": 0.8 },
         "gloss": { "model": "ward", "diffuse": 0.4, "specular": 0.3, "roughness": 0.2 })";
  std::string accuracy = "3 %";
  int seed = 1;

  [[nodiscard]] std::string text() const {
    return fmt::format(
        R"({{ "format": "goniolux-project", "version": 1, "materials": {{ {} }}, "objects": [ {} ], "luminaires": [ {} ],
              "grids": [ {} ], "settings": {{ "accuracy": {{ "grid": "{}" }}, "seed": {} }} }})",
        materials, fmt::join(objects, ","), fmt::join(luminaires, ","), fmt::join(grids, ","), accuracy, seed);
  }
};

/// An own pair of random numbers for each run that is compared with another: `seed`.
inline project::Results resultsOf(RoomText room, const std::string& solver, int seed = 1) {
  room.seed = seed;
  pipeline::StageRequest request;
  request.inputs = {"invariant/project.json"};
  request.projectText = room.text();
  request.common.solver = solver;
  const project::Project project = pipeline::readProjectFor(request, pipeline::AccuracyOf::grids);
  const pipeline::Engine engine(project, false);
  core::SilentProgress silent;
  return pipeline::calculateGrids(project, engine, silent);
}

inline std::string plane(const std::string& name, const std::string& place, const std::string& counts,
                         const std::string& normal = "[0,0,1]") {
  return fmt::format(R"({{ "name": "{}", {}, "counts": {}, "normal": {} }})", name, place, counts, normal);
}

/// A room of 4 x 3 x 2.5 m with a mirror and a table, a work plane of 8 x 6 points, no lamp yet.
inline RoomText furnishedRoom() {
  RoomText room;
  room.objects = {
      R"({ "name": "room", "shape": "box", "min": [0,0,0], "max": [4,3,2.5], "facing": "inward", "material": "grey" })",
      R"({ "name": "mirror", "shape": "rectangle", "origin": [0.01,0.5,0.5], "u": [0,2,0], "v": [0,0,1.5],
                       "material": "mirror" })",
      R"({ "name": "table", "shape": "box", "min": [2,1,0], "max": [3,2,0.7], "material": "gloss" })"};
  room.grids = {plane("g", R"("origin": [0,0,0.8], "u": [4,0,0], "v": [0,3,0])", "[8,6]")};
  return room;
}

inline std::string lampAt(const std::string& position, double flux = 3000, const std::string& name = "lamp") {
  return fmt::format(R"({{ "name": "{}", "photometry": "isotropic", "flux": {}, "position": {} }})", name, flux,
                     position);
}

inline std::string panelAt(const std::string& position, double length, double width, double flux,
                           const std::string& name = "panel", const std::string& more = "") {
  return fmt::format(
      R"({{ "name": "{}", "photometry": "cosine", "flux": {}, "position": {}, "shape": {{ "rectangle": {{ "length": {},
            "width": {} }} }} {} }})",
      name, flux, position, length, width, more);
}

/// All solvers; the second list: those that follow light from matt surface to matt surface.
inline std::vector<std::string> everySolver() {
  std::vector<std::string> names;
  for (const solver::SolverType& type : solver::solverTypes()) names.push_back(type.name);
  return names;
}
inline std::vector<std::string> interreflectingSolvers() {
  std::vector<std::string> names;
  for (const std::string& name : everySolver()) {
    RoomText room = furnishedRoom();
    room.luminaires = {lampAt("[2,1.5,2]")};
    room.accuracy = "50 %";
    bool lacks = false;
    for (const std::string& sentence : resultsOf(room, name).leftOut)
      lacks = lacks || sentence.find("interreflection between matt surfaces") != std::string::npos;
    if (!lacks) names.push_back(name);
  }
  return names;
}

}  // namespace goniolux::stability
