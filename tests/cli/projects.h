// Small projects for end-to-end tests, and folders compared before and after.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "support/temporary_folder.h"

namespace goniolux::test {

/// A closed room of 4 × 3 × 2.5 m, ρ = 0.5, with one isotropic point luminaire of 1000 lm, a grid of 4 × 3 points at
/// 0.8 m and a view of 32 × 24 pixels.
inline const std::string smallRoom = R"({
  "format": "goniolux-project", "version": 1, "name": "Small room", "units": "m",
  "materials": { "grey": { "model": "lambert", "diffuse": 0.5 } },
  "objects": [
    { "name": "room", "shape": "box", "min": [0,0,0], "max": [4,3,2.5], "facing": "inward", "material": "grey" } ],
  "luminaires": [ { "name": "L", "photometry": "isotropic", "flux": 1000, "position": [2,1.5,2] } ],
  "grids": [ { "name": "work plane", "origin": [0,0,0.8], "u": [4,0,0], "v": [0,3,0], "counts": [4,3],
               "normal": [0,0,1], "quantity": "illuminance" } ],
  "views": [ { "name": "door", "eye": [0.5,0.5,1.6], "target": [3,2.5,1], "up": [0,0,1], "fov": 60,
               "width": 32, "height": 24 } ]
}
)";

/// `text` with its only occurrence of `part` replaced; throws when there is not exactly one.
inline std::string changed(const std::string& text, const std::string& part, const std::string& replacement) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos || text.find(part, at + 1) != std::string::npos)
    throw std::logic_error("not exactly once in the project: " + part);
  return text.substr(0, at) + replacement + text.substr(at + part.size());
}

/// Every file below a folder with its content.
inline std::map<std::string, std::string> snapshot(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).generic_string()] = contentOf(entry.path());
  return files;
}

}  // namespace goniolux::test
