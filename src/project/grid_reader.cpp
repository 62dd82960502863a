#include "project/grid_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/quantity.h"
#include "core/closest_name.h"
#include "project/requirement_presets.h"
#include "project/section_reader.h"

namespace goniolux::project {
namespace {

/// Calls readOne for each entry of a list; one error when it is none.
template <typename ReadOne>
void forEach(const core::Value& section, const char* name, Reading& reading, ReadOne readOne) {
  if (!section.isArray()) {
    reading.error(section, "wrong-type", fmt::format("\"{0}\" must be a list: \"{0}\": [ {{ … }}, … ]", name));
    return;
  }
  for (const core::Value& entry : section.array()) readOne(entry);
}

bool readRegular(SectionReader& section, analysis::Grid& grid) {
  auto origin = section.point("origin"), u = section.point("u"), v = section.point("v");
  auto counts = section.counts("counts");
  const auto spacing = section.choice("spacing");
  if (spacing && section.has("counts")) {
    section.refuse("spacing", "grid-form", "give \"counts\" or \"spacing\", not both");
    return false;
  }
  for (const char* key : {"origin", "u", "v", "counts"}) {
    if (section.has(key) || (spacing && std::string(key) == "counts")) continue;
    section.refuse(
        key, "missing-key",
        fmt::format("a grid needs \"origin\", \"u\", \"v\" and \"counts\", or \"points\": \"{}\" is missing", key));
    return false;
  }
  if (!origin || !u || !v || (!counts && !spacing)) return false;
  const core::Vec3 area = glm::cross(*u, *v);
  // The sine of the angle between the edges; below a nanoradian the plane has no direction.
  if (!(glm::length(area) > 1e-9 * glm::length(*u) * glm::length(*v))) {
    section.refuse("u", "zero-vector",
                   "\"u\" and \"v\" span no area: both need a length, and they must not be parallel");
    return false;
  }
  const auto normal = section.direction("normal");
  if (section.has("normal") && !normal) return false;
  if (const auto border = section.length("border"); border && *border > 0) {
    const double length = glm::length(*u), width = glm::length(*v);
    if (2 * *border >= std::min(length, width)) {
      section.refuse("border", "out-of-range", "the border takes up the whole grid; make it smaller");
      return false;
    }
    *origin += *border / length * *u + *border / width * *v;
    *u *= 1 - 2 * *border / length;
    *v *= 1 - 2 * *border / width;
  }
  if (section.failed()) return false;
  if (spacing) counts = en12464Counts(glm::length(*u), glm::length(*v));
  grid.origin = *origin;
  grid.u = *u;
  grid.v = *v;
  grid.counts = *counts;
  for (int j = 0; j < (*counts)[1]; ++j) {
    for (int i = 0; i < (*counts)[0]; ++i) {
      grid.points.push_back(*origin + (i + 0.5) / (*counts)[0] * *u + (j + 0.5) / (*counts)[1] * *v);
    }
  }
  grid.normals.assign(grid.points.size(), normal.value_or(glm::normalize(area)));
  return true;
}

bool readPointList(SectionReader& section, analysis::Grid& grid) {
  for (const char* key : {"origin", "u", "v", "counts", "spacing", "border"}) {
    if (!section.has(key)) continue;
    section.refuse(key, "grid-form", fmt::format("a grid of \"points\" has no \"{}\"", key));
    return false;
  }
  const auto points = section.points("points");
  const auto normal = section.direction("normal");
  const auto normals = section.directions("normals");
  if (section.failed() || !points) return false;
  if (normal && normals) {
    section.refuse("normals", "grid-form", "give \"normal\" for all points or \"normals\" for each, not both");
    return false;
  }
  if (normals && normals->size() != points->size()) {
    section.refuse("normals", "grid-form",
                   fmt::format("there are {} \"points\" but {} \"normals\"", points->size(), normals->size()));
    return false;
  }
  grid.points = *points;
  grid.normals = normals.value_or(std::vector<core::Vec3>(points->size(), normal.value_or(core::Vec3(0, 0, 1))));
  return true;
}

// The axis of cylindrical quantities; a half cylinder's normal is made perpendicular to it.
bool readAxis(SectionReader& section, analysis::Grid& grid) {
  const analysis::Quantity* quantity = analysis::findQuantity(grid.quantity);
  if (quantity == nullptr) return false;  // refused already
  if (section.has("axis") && !quantity->hasAxis) {
    section.refuse("axis", "grid-form", fmt::format("\"axis\" means nothing for the quantity \"{}\"", grid.quantity));
    return false;
  }
  grid.axis = section.direction("axis").value_or(core::Vec3(0, 0, 1));
  if (quantity->body != solver::ReceiverBody::halfCylinder) return true;
  for (core::Vec3& normal : grid.normals) {
    const core::Vec3 across = normal - grid.axis * glm::dot(grid.axis, normal);
    if (!(glm::length(across) > 1e-6)) {
      section.refuse("quantity", "grid-form",
                     "a half cylinder needs to know where it faces: give a \"normal\" that is not along its axis");
      return false;
    }
    normal = glm::normalize(across);
  }
  return true;
}

std::optional<analysis::Limit> readLimit(const core::Value& value, const std::string& key, Reading& reading) {
  SectionReader section(value, limitSection(), reading);
  if (section.failed()) return std::nullopt;
  const analysis::Limit limit{key, section.number("min"), section.number("max")};
  if (section.failed()) return std::nullopt;
  if (!limit.minimum && !limit.maximum) {
    reading.error(value, "missing-key", fmt::format("\"{}\" needs \"min\" or \"max\"", key));
    return std::nullopt;
  }
  if (limit.minimum && limit.maximum && *limit.minimum > *limit.maximum) {
    reading.error(value, "out-of-range", fmt::format("\"{}\": \"min\" exceeds \"max\": nothing can satisfy both", key));
    return std::nullopt;
  }
  return limit;
}

void checkTarget(SectionReader& section, const char* key, const std::string& name,
                 const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  section.refuse(key, "unknown-name", fmt::format("there is no {} \"{}\"{}", key, name, core::suggestion(name, known)));
}

/// A standard's limits are a requirement of their own, with the clause; what the project gives beside them another.
void addPreset(SectionReader& section, const analysis::Requirement& target,
               std::vector<analysis::Requirement>& requirements) {
  const auto name = section.choice("preset"), area = section.choice("area");
  if (section.has("area") && !section.has("preset"))
    section.refuse("area", "missing-key", "an \"area\" belongs to a \"preset\"");
  const RequirementPreset* preset = name ? findRequirementPreset(*name) : nullptr;
  if (!preset || section.failed()) return;
  analysis::Requirement standard = target;
  standard.clause = preset->reference();
  standard.limits.clear();
  if (target.grid.empty()) {
    if (preset->ugr) standard.limits.push_back({"ugr", std::nullopt, preset->ugr});
  } else {
    standard.limits = presetLimits(*preset, area.value_or("task"));
  }
  if (standard.limits.empty()) {
    section.refuse("preset", "no-limit",
                   target.grid.empty() ? fmt::format("{} states no glare limit; give a \"grid\"", preset->reference())
                                       : fmt::format("{} states no limit for the area \"{}\"", preset->reference(),
                                                     area.value_or("task")));
    return;
  }
  requirements.push_back(std::move(standard));
}

}  // namespace

std::vector<analysis::Grid> readGrids(const core::Value& value, Reading& reading) {
  std::vector<analysis::Grid> grids;
  forEach(value, "grids", reading, [&](const core::Value& entry) {
    SectionReader section(entry, gridSection(), reading);
    if (!section.isObject()) return;
    analysis::Grid grid;
    grid.position = entry.position();
    grid.name = section.text("name").value_or("");
    grid.quantity = section.choice("quantity").value_or("illuminance");
    if (!section.has("points") && section.has("normals")) {
      section.refuse("normals", "grid-form", "\"normals\" go with \"points\"; a regular grid has one \"normal\"");
      return;
    }
    const bool good = section.has("points") ? readPointList(section, grid) : readRegular(section, grid);
    if (good && readAxis(section, grid)) grids.push_back(std::move(grid));
  });
  return grids;
}

std::vector<analysis::Observer> readObservers(const core::Value& value, Reading& reading) {
  std::vector<analysis::Observer> observers;
  forEach(value, "observers", reading, [&](const core::Value& entry) {
    SectionReader section(entry, observerSection(), reading);
    if (!section.isObject()) return;
    analysis::Observer observer;
    observer.position = entry.position();
    observer.name = section.text("name").value_or("");
    observer.quantity = section.choice("quantity").value_or("ugr");
    const auto eye = section.point("eye"), direction = section.direction("direction");
    if (!eye || !direction) return;
    observer.eye = *eye;
    observer.direction = *direction;
    observers.push_back(std::move(observer));
  });
  return observers;
}

std::vector<analysis::Requirement> readRequirements(const core::Value& value, const std::vector<std::string>& grids,
                                                    const std::vector<std::string>& observers, Reading& reading) {
  static const std::array<const char*, 6> ofGrids{"mean_lx", "min_lx", "max_lx", "u0", "ud", "ra"};
  std::vector<analysis::Requirement> requirements;
  forEach(value, "requirements", reading, [&](const core::Value& entry) {
    SectionReader section(entry, requirementSection(), reading);
    if (section.failed()) return;
    const auto grid = section.text("grid"), observer = section.text("observer");
    if (section.failed()) return;
    if (grid.has_value() == observer.has_value()) {
      reading.error(entry, "missing-key", "a requirement is about either a \"grid\" or an \"observer\"");
      return;
    }
    analysis::Requirement requirement{grid.value_or(""), observer.value_or(""), {}, entry.position()};
    if (grid) checkTarget(section, "grid", *grid, grids);
    if (observer) checkTarget(section, "observer", *observer, observers);
    for (const auto& [key, limitValue] : entry.object()) {
      if (key == "grid" || key == "observer" || key == "preset" || key == "area") continue;
      const bool forGrid = std::find(ofGrids.begin(), ofGrids.end(), key) != ofGrids.end();
      if (forGrid != grid.has_value()) {
        reading.diagnostics.error(limitValue.keyPosition(), "unknown-key",
                                  fmt::format("\"{}\" is a limit for {}", key, forGrid ? "grids" : "observers"));
      } else if (auto limit = readLimit(limitValue, key, reading)) {
        requirement.limits.push_back(std::move(*limit));
      }
    }
    addPreset(section, requirement, requirements);
    if (entry.object().size() == 1) {
      reading.error(entry, "missing-key", "this requirement states no limit; add e.g. \"mean_lx\": { \"min\": 500 }");
    }
    if (!requirement.limits.empty()) requirements.push_back(std::move(requirement));
  });
  return requirements;
}

std::vector<std::string> namesIn(const core::Value* section) {
  std::vector<std::string> names;
  if (!section || !section->isArray()) return names;
  for (const core::Value& entry : section->array()) {
    const core::Value* name = entry.find("name");
    if (name && name->isString()) names.push_back(name->string());
  }
  return names;
}

}  // namespace goniolux::project
