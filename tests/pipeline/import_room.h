// A room of one box and one luminaire, and a model that is imported into it.
#pragma once

#include <map>
#include <string>

#include "core/progress.h"
#include "pipeline/stages.h"

namespace goniolux::pipeline {

inline const std::string room = R"({ "format": "goniolux-project", "version": 1, // a comment stays
  "materials": { "grey": { "model": "lambert", "diffuse": 0.5 } },
  "objects": [
    { "name": "room", "shape": "box", "min": [0,0,0], "max": [4,3,2.5], "facing": "inward", "material": "grey" } // last
  ],
  "luminaires": [ { "photometry": "isotropic", "flux": 1000, "position": [2,1.5,2] } ],
  "grids": [ { "name": "plane", "origin": [0,0,0.8], "u": [4,0,0], "v": [0,3,0], "counts": [4,3] } ] }
)";

inline StageReport import(const std::string& model, const std::string& project,
                          std::map<std::string, std::string> options = {}) {
  core::SilentProgress silent;
  StageRequest request;
  request.inputs = {model};
  options["into"] = project;
  request.options = options;
  return importStage().run(request, silent);
}

}  // namespace goniolux::pipeline
