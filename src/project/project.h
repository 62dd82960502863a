// Project: a whole project file, read, checked and converted to SI.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/grid.h"
#include "core/diagnostics.h"
#include "core/document.h"
#include "photometry/photometric_file.h"
#include "project/results.h"
#include "scene/environment.h"
#include "scene/view.h"
#include "spectrum/spectral_distribution.h"

namespace goniolux::project {

/// A relative accuracy (0.01 = 1 %) or an absolute one, as the key says.
struct AccuracyAsked {
  double grid = 0.02, u0 = 0.03, ugr = 0.3, image = 0.05, colourDe = 1.0, confidence = 0.95;
};

struct Settings {
  AccuracyAsked accuracy;
  std::string solver = "auto";
  std::string reflectionModel = "material";
  bool asPrinted = false;
  spectrum::SpectralDistribution ambient;  ///< I_a, cd/m2
  std::string spectralScheme = "auto";
  int spectralSamples = 0;  ///< 0 = the scheme's choice
  int treeMaxDepth = 15;
  double treeCutoff = 0.001;
  bool treeAdaptive = true;
  int pixelMinSamples = 1, pixelMaxSamples = 256;
  double pixelContrast = 0.02;
  std::string pixelFilter = "box";
  std::optional<double> timeLimit_s;
  std::uint64_t seed = 1;
};

/// A lighting scene: a dimming factor per group; groups not listed are off.
struct LightingScene {
  std::string name;
  std::map<std::string, double> groups;
};

struct Project {
  std::string name, file, folder;  ///< file: the project.json, folder: where it stands
  std::string units = "m";
  scene::Environment environment;
  std::vector<analysis::Grid> grids;
  std::vector<analysis::Observer> observers;
  std::vector<analysis::Requirement> requirements;
  std::vector<scene::View> views;
  std::vector<LightingScene> scenes;
  Settings settings;
  std::vector<InputFile> inputs;  ///< every file read, the project file first
  std::string hash;               ///< sha256 over all inputs: identifies what was calculated
  core::Diagnostics warnings;
};

/// Overrides from the command line: "KEY=VALUE" for any settings key, e.g. "tree.cutoff=0.01", and a lighting scene's
/// name.
struct Overrides {
  std::vector<std::string> settings;
  std::optional<std::string> scene;
};

/// Reads PROJECT (a folder or a project.json). Throws core::InputError listing every error found.
Project readProject(const std::string& path, const Overrides& overrides = {});
/// The same of a text that is not, or not yet, in the project file: what an interface has open. `file` is the
/// project.json that it belongs to, in messages and for the files that it names.
Project readProjectText(const std::string& text, const std::string& file, const Overrides& overrides = {});

}  // namespace goniolux::project
