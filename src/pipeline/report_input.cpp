#include "pipeline/report_input.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "photometry/metrics.h"
#include "pipeline/luminaire_sheet.h"
#include "pipeline/plan_map.h"
#include "pipeline/plot.h"
#include "pipeline/polar.h"
#include "project/reading.h"
#include "report/words.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "spectrum/colour_rendering.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using report::LuminaireType;

/// A, B … Z, A2, B2 …
std::string letterOf(std::size_t index) {
  std::string letter(1, static_cast<char>('A' + index % 26));
  return index < 26 ? letter : letter + std::to_string(index / 26 + 1);
}

report::Opening openingOf(const photometry::StatedOpening& o) {
  using Shape = photometry::StatedOpening::Shape;
  using Axis = photometry::StatedOpening::Axis;
  if (o.shape == Shape::point) return {"point", 0, 0, 0};
  if (o.shape == Shape::other) return {o.note, 0, 0, 0};
  std::string shape = shapeName(o);
  if (o.shape == Shape::cylinder)
    shape = (o.axis == Axis::aim ? "upright " : "horizontal ") + shape;
  else if (o.axis != Axis::aim)
    shape = "upright " + shape;
  return {shape, o.lengthAlongC90 ? o.width : o.length, o.lengthAlongC90 ? o.length : o.width, o.height};
}

/// Colour temperature and rendering, where the project states a spectrum and it is that of a white.
void describeColour(const spectrum::SpectralDistribution& light, LuminaireType& type) {
  if (light.isFlat()) return;             // what stands in for a spectrum that is not stated
  constexpr double farthestWhite = 0.05;  // CIE 015: beyond it a colour temperature means nothing
  const spectrum::ColourTemperature t = spectrum::colourTemperature(spectrum::tristimulus(light));
  if (std::abs(t.duv) > farthestWhite) return;
  type.cct_K = 10 * std::round(t.kelvin / 10);
  type.ra = spectrum::colourRendering(light).ra;
}

void describe(const photometry::PhotometricFile& file, LuminaireType& type) {
  const auto keyword = [&](const char* key) {
    const auto found = file.keywords.find(key);
    return found == file.keywords.end() ? std::string() : found->second.substr(0, found->second.find('\n'));
  };
  type.product = keyword("LUMINAIRE");
  type.maker = keyword("MANUFAC");
  type.catalogue = keyword("LUMCAT");
  type.opening = openingOf(file.opening);
  const double share = file.distribution->flux() > 0 ? type.flux_lm / file.distribution->flux() : 1;
  type.maximum_cd = share * file.distribution->maximumIntensity();
  type.downwardShare = file.distribution->flux() > 0 ? file.distribution->forwardFlux() / file.distribution->flux() : 1;
  using photometry::PrincipalPlane;
  const auto width = [&](PrincipalPlane plane, double fraction) {
    return photometry::fullWidth(*file.distribution, plane, fraction);
  };
  type.beamC0_deg = width(PrincipalPlane::c0_180, 0.5), type.beamC90_deg = width(PrincipalPlane::c90_270, 0.5);
  type.fieldC0_deg = width(PrincipalPlane::c0_180, 0.1), type.fieldC90_deg = width(PrincipalPlane::c90_270, 0.1);
  type.polar = polarDiagramOf(file);
  // The diagram is of the luminaire as it is used, not of the file.
  for (plot::PolarCurve& curve : type.polar->curves)
    for (auto& [angle, intensity] : curve.points) intensity *= share;
}

project::GridResult inUnits(project::GridResult grid, const report::Words& words) {
  const double length = words.factor("m"), light = words.factor(grid.unit);
  for (core::Vec3& p : grid.points) p *= length;
  if (grid.plane)
    grid.plane = project::GridPlane{length * grid.plane->origin, length * grid.plane->u, length * grid.plane->v};
  for (std::vector<double>* list : {&grid.values, &grid.halfWidths})
    for (double& value : *list) value *= light;
  grid.unit = words.unitName(grid.unit);
  return grid;
}

Outline inUnits(Outline outline, const report::Words& words) {
  const double length = words.factor("m");
  outline.low *= length, outline.high *= length;
  for (ObjectOutline& object : outline.objects)
    for (std::vector<Segment>* segments : {&object.edges, &object.plan})
      for (Segment& s : *segments) s.from *= length, s.to *= length;
  for (LuminaireOutline& luminaire : outline.luminaires) {
    luminaire.position *= length;
    for (core::Vec3& corner : luminaire.footprint) corner *= length;
  }
  return outline;
}

std::string axisTitle(const std::string& title, const report::Words& words) {
  const std::size_t slash = title.rfind(" / ");
  return words(title.substr(0, slash)) + " / " + words.unitName("m");
}

}  // namespace

std::vector<LuminaireType> luminaireTypes(const project::Project& project, core::Diagnostics& warnings) {
  std::vector<LuminaireType> types;
  project::Reading reading(project.folder);
  for (const scene::Luminaire& luminaire : project.environment.luminaires) {
    auto type = std::find_if(types.begin(), types.end(), [&](const auto& t) { return t.name == luminaire.type; });
    if (type == types.end()) {
      LuminaireType fresh;
      fresh.letter = letterOf(types.size());
      fresh.name = luminaire.type;
      fresh.file = luminaire.photometry;
      fresh.flux_lm = luminaire.flux_lm;
      fresh.watts = luminaire.watts;
      fresh.maintenance = luminaire.maintenance;
      fresh.dimming = luminaire.dimming;
      describeColour(project.environment.sourceSpectra[luminaire.spectrum], fresh);
      fs::path extension = fs::path(luminaire.photometry).extension();
      fresh.isFile = !extension.empty();
      if (fresh.isFile) {
        const auto path = reading.file(core::Value(luminaire.photometry), project::Library::luminaires);
        try {
          if (path) describe(photometry::readPhotometricFile(*path), fresh);
        } catch (const core::InputError& error) {
          warnings.warning({luminaire.photometry}, "no-luminaire-sheet", error.what());
        }
      }
      types.push_back(std::move(fresh));
      type = std::prev(types.end());
    }
    ++type->count;
    type->positions.push_back(luminaire.center);
  }
  return types;
}

std::vector<report::Surface> roomSurfaces(const project::Project& project) {
  std::vector<report::Surface> surfaces;
  const spectrum::SpectralDistribution& v = spectrum::cie1931().ybar;
  for (const scene::Object& object : project.environment.objects) {
    if (!object.facesInward) continue;
    // Parts of one material are told once, under the names of all.
    std::vector<std::pair<std::uint32_t, std::string>> groups;
    const std::vector<std::string>& parts = object.shape.partNames;
    for (std::size_t i = 0; i < object.materials.size() && i < parts.size(); ++i) {
      const auto known = std::find_if(groups.begin(), groups.end(),
                                      [&](const auto& group) { return group.first == object.materials[i]; });
      if (known == groups.end())
        groups.emplace_back(object.materials[i], parts[i]);
      else
        known->second += ", " + parts[i];
    }
    for (const auto& [index, names] : groups) {
      const material::Material& m = project.environment.materials[index];
      auto curve = m.spectra.find("diffuse");
      if (curve == m.spectra.end()) curve = m.spectra.find("reflectance");
      if (curve == m.spectra.end()) continue;
      surfaces.push_back({object.name, names, m.name, curve->second.integral(v) / v.integral()});
    }
  }
  return surfaces;
}

std::optional<double> floorArea(const project::Project& project) {
  double area = 0;
  for (const scene::Object& object : project.environment.objects) {
    if (!object.facesInward) continue;
    if (!object.shape.patches.empty()) return std::nullopt;
    const geometry::Mesh& mesh = object.shape.mesh;
    for (const core::Mat4& place : scene::placesOf(object)) {
      const auto at = [&](std::uint32_t i) { return core::Vec3(place * glm::dvec4(mesh.vertices[i], 1.0)); };
      for (const auto& t : mesh.triangles) area += std::abs(glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])).z) / 4;
    }
  }
  return area > 0 ? std::optional(area) : std::nullopt;
}

report::Plan planOf(const Outline& outline, const project::Results& results, const std::vector<LuminaireType>& types) {
  report::Plan plan;
  const auto flat = [](const core::Vec3& p) { return core::Vec2(p.x, p.y); };
  std::vector<std::pair<core::Vec2, core::Vec2>> room, objects;
  for (const ObjectOutline& object : outline.objects)
    for (const Segment& s : object.plan) (object.isRoom ? room : objects).emplace_back(flat(s.from), flat(s.to));
  const double tolerance = 1e-5 * std::max(glm::distance(outline.low, outline.high), 1e-3);
  plan.roomLines = plot::joined(room, tolerance);
  plan.objectLines = plot::joined(objects, tolerance);
  for (const LuminaireOutline& luminaire : outline.luminaires) {
    report::Plan::Symbol symbol{"", flat(luminaire.position), {}};
    for (const LuminaireType& type : types)
      if (type.name == luminaire.type) symbol.letter = type.letter;
    for (const core::Vec3& corner : luminaire.footprint) symbol.footprint.push_back(flat(corner));
    plan.luminaires.push_back(std::move(symbol));
  }
  for (const project::GridResult& grid : results.grids) {
    if (!grid.plane || std::abs(grid.plane->u.z) + std::abs(grid.plane->v.z) > 1e-6) continue;
    const project::GridPlane& p = *grid.plane;
    plan.grids.push_back(
        {grid.name, {flat(p.origin), flat(p.origin + p.u), flat(p.origin + p.u + p.v), flat(p.origin + p.v)}});
  }
  return plan;
}

std::vector<std::string> staleInputs(const project::Results& results, const project::Project& project) {
  std::vector<std::string> changed;
  for (const project::InputFile& was : results.inputs) {
    const auto is = std::find_if(project.inputs.begin(), project.inputs.end(),
                                 [&](const project::InputFile& input) { return input.path == was.path; });
    if (is == project.inputs.end() || is->sha256 != was.sha256) changed.push_back(was.path);
  }
  return changed;
}

std::optional<report::Picture> gridMap(const project::Results& results, std::size_t index, const Outline* outline,
                                       report::Language language, report::Units units, core::Diagnostics& warnings) {
  const report::Words words(language, units);
  const project::GridResult grid = inUnits(results.grids[index], words);
  if (std::all_of(grid.values.begin(), grid.values.end(), [](double v) { return std::isnan(v); })) return std::nullopt;
  const std::optional<Outline> converted = outline ? std::optional(inUnits(*outline, words)) : std::nullopt;
  plot::PlanMap map = planMapOf(results, grid, converted ? &*converted : nullptr, {});
  map.title = map.subtitle = map.footer = "";
  map.facts.clear();
  if (grid.quantity == "illuminance") map.legendTitle = words("Illuminance");
  map.xTitle = axisTitle(map.xTitle, words);
  map.yTitle = axisTitle(map.yTitle, words);
  for (const char* word : {"in", "luminaire", "highest value", "lowest value", "not counted"})
    map.words[word] = words(word);

  const fs::path base = fs::temp_directory_path() / fmt::format("goniolux-report-{}-{}", getpid(), index);
  const std::string figure = base.string() + ".json", picture = base.string() + ".png";
  core::writeFile(figure, core::toJson(plot::toJson(map)));
  const std::string trouble = drawFigure(figure, {picture});
  std::error_code ignored;
  fs::remove(figure, ignored);
  if (!trouble.empty() || !fs::exists(picture, ignored)) {
    warnings.warning({}, "cannot-draw", fmt::format("the map of grid \"{}\" is missing: {}", grid.name, trouble));
    return std::nullopt;
  }
  report::Picture result{grid.name, "image/png", core::readFile(picture)};
  fs::remove(picture, ignored);
  return result;
}

}  // namespace goniolux::pipeline
