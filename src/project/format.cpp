#include "project/format.h"

#include <algorithm>

#include "analysis/quantity.h"
#include "project/requirement_presets.h"
#include "reflection/shading.h"
#include "solver/solver.h"
#include "spectrum/schemes.h"
#include "viewing/pixel_filter.h"

namespace goniolux::project {
namespace {

constexpr double largestSeed = 9007199254740992.0;  // 2^53: whole numbers of JSON are doubles
constexpr double mostPixels = 32768;

/// "auto" and every solver of the registry.
std::vector<std::string> solverNames() {
  std::vector<std::string> names{"auto"};
  for (const solver::SolverType& type : solver::solverTypes()) names.push_back(type.name);
  return names;
}

std::vector<std::string> forcedModels() {
  std::vector<std::string> names{"material"};
  for (const reflection::ShadingModel& model : reflection::shadingModels()) names.push_back(model.name);
  return names;
}

Key limitKey(const char* name, const char* help) {
  return {.name = name, .form = Form::section, .help = help, .section = &limitSection()};
}

std::vector<std::string> spectralSchemeNames() {
  std::vector<std::string> names = {"auto"};
  for (const spectrum::SpectralScheme& scheme : spectrum::spectralSchemes()) names.push_back(scheme.name);
  return names;
}

std::vector<std::string> pixelFilterNames() {
  std::vector<std::string> names;
  for (const viewing::PixelFilter& filter : viewing::pixelFilters()) names.push_back(filter.name);
  return names;
}

}  // namespace

const Key* Section::find(std::string_view name) const {
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
  return found == keys.end() ? nullptr : &*found;
}

std::vector<std::string> Section::names() const {
  std::vector<std::string> list;
  for (const Key& key : keys) list.push_back(key.name);
  return list;
}

const Section& rootSection() {
  static const Section section{
      "a project",
      {{.name = "format",
        .form = Form::choice,
        .help = "what this file is",
        .required = true,
        .choices = {"goniolux-project"}},
       {.name = "version",
        .form = Form::integer,
        .help = "of the format",
        .required = true,
        .minimum = 1,
        .maximum = 1},
       {.name = "name", .form = Form::text, .help = "title of the project"},
       {.name = "units",
        .form = Form::choice,
        .help = "of all lengths in this file",
        .choices = {"m", "mm", "cm", "ft", "in"}},
       {.name = "materials", .form = Form::materials, .help = "finishes by name"},
       {.name = "objects", .form = Form::objects, .help = "what light meets", .required = true},
       {.name = "luminaires",
        .form = Form::sections,
        .help = "what light comes from",
        .required = true,
        .section = &luminaireSection()},
       {.name = "scenes", .form = Form::sections, .help = "lighting scenes", .section = &lightingSceneSection()},
       {.name = "grids", .form = Form::sections, .help = "where illuminance is wanted", .section = &gridSection()},
       {.name = "observers", .form = Form::sections, .help = "where glare is rated", .section = &observerSection()},
       {.name = "views", .form = Form::sections, .help = "pictures", .section = &viewSection()},
       {.name = "requirements", .form = Form::sections, .help = "limits to be kept", .section = &requirementSection()},
       {.name = "settings", .form = Form::section, .help = "how to calculate", .section = &settingsSection()}}};
  return section;
}

const Section& gridSection() {
  static const Section section{
      "a grid",
      {{.name = "name", .form = Form::text, .help = "unique; names its result files", .required = true},
       {.name = "origin", .form = Form::point, .help = "corner of the measuring plane"},
       {.name = "u", .form = Form::point, .help = "full edge along which values run fastest"},
       {.name = "v", .form = Form::point, .help = "full other edge"},
       {.name = "counts", .form = Form::counts, .help = "points along u and v, at cell centres"},
       {.name = "spacing",
        .form = Form::choice,
        .help =
            "instead of counts: p = 0.2 * 5^(log10 d) m, d the longer edge (the shorter when it is half of it or less)",
        .choices = {"EN 12464-1"}},
       {.name = "border",
        .form = Form::length,
        .help = "left free along all four edges, e.g. 0.5 m along walls",
        .minimum = 0},
       {.name = "points", .form = Form::points, .help = "single points instead of origin, u, v and counts"},
       {.name = "normal", .form = Form::direction, .help = "that the measuring surface faces; default u x v, or up"},
       {.name = "normals", .form = Form::directions, .help = "one for each of points"},
       {.name = "quantity", .form = Form::choice, .help = "what is measured", .choices = analysis::quantityNames()},
       {.name = "axis", .form = Form::direction, .help = "of cylindrical quantities; default up"}}};
  return section;
}

const Section& observerSection() {
  static const Section section{"an observer",
                               {{.name = "name", .form = Form::text, .help = "unique", .required = true},
                                {.name = "eye", .form = Form::point, .help = "position of the eye", .required = true},
                                {.name = "direction", .form = Form::direction, .help = "of view", .required = true},
                                {.name = "quantity", .form = Form::choice, .help = "rating", .choices = {"ugr"}}}};
  return section;
}

const Section& viewSection() {
  static const Section section{
      "a view",
      {{.name = "name", .form = Form::text, .help = "unique; names its result files", .required = true},
       {.name = "eye", .form = Form::point, .help = "viewpoint", .required = true},
       {.name = "target", .form = Form::point, .help = "point in the middle of the picture", .required = true},
       {.name = "up", .form = Form::direction, .help = "points up in the picture; default [0, 0, 1]"},
       {.name = "fov",
        .form = Form::fieldOfView,
        .help = "vertical degrees, or {\"horizontal\": degrees}; default 60",
        .minimum = 0,
        .maximum = 360,
        .minimumIsAllowed = false,
        .unit = "°"},
       {.name = "span",
        .form = Form::length,
        .help = "height of the picture (orthographic)",
        .minimum = 0,
        .minimumIsAllowed = false},
       {.name = "width",
        .form = Form::integer,
        .help = "pixels; default 640",
        .minimum = 1,
        .maximum = mostPixels,
        .unit = "px"},
       {.name = "height",
        .form = Form::integer,
        .help = "pixels; default 480",
        .minimum = 1,
        .maximum = mostPixels,
        .unit = "px"},
       {.name = "projection",
        .form = Form::choice,
        .help = "default perspective",
        .choices = {"perspective", "orthographic", "fisheye-equidistant", "fisheye-equisolid"}}}};
  return section;
}

const Section& horizontalFieldSection() {
  static const Section section{"a field of view",
                               {{.name = "horizontal",
                                 .form = Form::number,
                                 .help = "degrees",
                                 .required = true,
                                 .minimum = 0,
                                 .maximum = 360,
                                 .minimumIsAllowed = false}}};
  return section;
}

const Section& requirementSection() {
  static const Section section{
      "a requirement",
      {{.name = "grid", .form = Form::text, .help = "name of the grid that it is about"},
       {.name = "observer", .form = Form::text, .help = "name of the observer that it is about"},
       limitKey("mean_lx", "mean illuminance"),
       limitKey("min_lx", "smallest illuminance"),
       limitKey("max_lx", "largest illuminance"),
       limitKey("u0", "uniformity, smallest by mean"),
       limitKey("ud", "diversity, smallest by largest"),
       limitKey("ugr", "unified glare rating"),
       limitKey("ra", "general colour rendering index of the luminaires' light"),
       {.name = "preset",
        .form = Form::choice,
        .help = "limits of a standard; others given beside it are kept too",
        .choices = requirementPresetNames()},
       {.name = "area",
        .form = Form::choice,
        .help = "what of the preset the grid is; default task",
        .choices = requirementAreas()}}};
  return section;
}

const Section& limitSection() {
  static const Section section{"a limit",
                               {{.name = "min", .form = Form::number, .help = "at least", .minimum = 0},
                                {.name = "max", .form = Form::number, .help = "at most", .minimum = 0}}};
  return section;
}

const Section& lightingSceneSection() {
  static const Section section{"a scene",
                               {{.name = "name", .form = Form::text, .help = "unique; --scene NAME", .required = true},
                                {.name = "groups",
                                 .form = Form::numberMap,
                                 .help = "dimming by luminaire group; a group not listed is off",
                                 .required = true,
                                 .minimum = 0}}};
  return section;
}

const Section& settingsSection() {
  static const Section section{
      "settings",
      {{.name = "accuracy", .form = Form::section, .help = "asked for", .section = &accuracySection()},
       {.name = "ambient",
        .form = Form::quantity,
        .help = "the paper's I_a in cd/m2, for solver \"tree\"",
        .minimum = 0},
       {.name = "solver", .form = Form::choice, .help = "default auto", .choices = solverNames()},
       {.name = "reflection_model",
        .form = Form::choice,
        .help = "of all finishes; default: each material's own",
        .choices = forcedModels()},
       {.name = "as_printed", .form = Form::boolean, .help = "the paper's formulas taken literally"},
       {.name = "spectral", .form = Form::spectral, .help = "wavelengths that rays carry; default auto"},
       {.name = "tree", .form = Form::section, .help = "of solver \"tree\"", .section = &treeSection()},
       {.name = "pixel", .form = Form::section, .help = "samples of a pixel", .section = &pixelSection()},
       {.name = "time_limit_s",
        .form = Form::numberOrNull,
        .help = "seconds; null = none",
        .minimum = 0,
        .minimumIsAllowed = false},
       {.name = "seed",
        .form = Form::integer,
        .help = "of the random numbers; default 1",
        .minimum = 0,
        .maximum = largestSeed}}};
  return section;
}

const Section& accuracySection() {
  static const Section section{
      "accuracy",
      {{.name = "grid", .form = Form::percentage, .help = "of illuminances; default 2 %"},
       {.name = "u0", .form = Form::percentage, .help = "of the uniformity; default 3 %"},
       {.name = "ugr", .form = Form::number, .help = "default 0.3", .minimum = 0, .minimumIsAllowed = false},
       {.name = "image", .form = Form::percentage, .help = "of luminances; default 5 %"},
       {.name = "colour_de",
        .form = Form::number,
        .help = "CIEDE2000; default 1",
        .minimum = 0,
        .minimumIsAllowed = false},
       {.name = "confidence", .form = Form::number, .help = "default 0.95", .minimum = 0.5, .maximum = 0.9999}}};
  return section;
}

const Section& treeSection() {
  static const Section section{
      "tree",
      {{.name = "max_depth", .form = Form::integer, .help = "default 15", .minimum = 1, .maximum = 10000},
       {.name = "cutoff", .form = Form::number, .help = "default 0.001", .minimum = 0, .maximum = 1},
       {.name = "adaptive", .form = Form::boolean, .help = "default true"}}};
  return section;
}

const Section& pixelSection() {
  static const Section section{
      "pixel",
      {{.name = "min_samples",
        .form = Form::integer,
        .help = "taken of every pixel, and at least 16; default 1",
        .minimum = 1,
        .maximum = 1e6},
       {.name = "max_samples",
        .form = Form::integer,
        .help = "at most, whatever is asked; default 256",
        .minimum = 1,
        .maximum = 1e6},
       {.name = "contrast",
        .form = Form::number,
        .help = "edges are divided until less is uncertain, as (Lmax - Lmin)/(Lmax + Lmin); 1 = never; default 0.02",
        .minimum = 0,
        .maximum = 1},
       {.name = "filter",
        .form = Form::choice,
        .help = "what a pixel is the mean of: its own square (box), or wider with smoother edges; default box",
        .choices = pixelFilterNames()}}};
  return section;
}

const Section& spectralSection() {
  static const Section section{
      "spectral",
      {{.name = "scheme",
        .form = Form::choice,
        .help = "how wavelengths are chosen",
        .required = true,
        .choices = spectralSchemeNames()},
       {.name = "samples", .form = Form::integer, .help = "wavelengths", .minimum = 1, .maximum = 471}}};
  return section;
}

}  // namespace goniolux::project
