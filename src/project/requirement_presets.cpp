#include "project/requirement_presets.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "core/document.h"
#include "core/embedded.h"

namespace goniolux::project {

std::span<const core::EmbeddedText> requirementTexts();  // made from data/requirements/*.json when the program is built

namespace {

using core::Value;

std::optional<double> number(const Value& entry, const char* key) {
  const Value* value = entry.find(key);
  return value ? std::optional(value->number()) : std::nullopt;
}

std::vector<RequirementPreset> readPresets() {
  std::vector<RequirementPreset> presets;
  for (const core::EmbeddedText& file : requirementTexts()) {
    core::Diagnostics diagnostics;
    const Value root = core::parseJson(std::string(file.text), std::string(file.name), diagnostics);
    assert(!diagnostics.hasErrors());  // the program's own data, held by tests/project
    for (const Value& entry : root.find("entries")->array()) {
      RequirementPreset preset;
      preset.name = root.find("key")->string() + ":" + entry.find("id")->string();
      preset.standard = root.find("standard")->string();
      preset.clause = entry.find("clause")->string();
      preset.title = entry.find("title")->string();
      preset.mean = number(entry, "mean_lx");
      preset.minimum = number(entry, "min_lx");
      preset.u0 = number(entry, "u0");
      preset.ud = number(entry, "ud");
      preset.ugr = number(entry, "ugr");
      preset.ra = number(entry, "ra");
      preset.cylindrical = number(entry, "cylindrical_lx");
      preset.wall = number(entry, "wall_lx");
      preset.ceiling = number(entry, "ceiling_lx");
      if (const Value* page = entry.find("compared_with")) preset.comparedWith = page->string();
      preset.hasSurrounding = root.find("key")->string() == "en-12464-1";
      presets.push_back(std::move(preset));
    }
  }
  return presets;
}

/// EN 12464-1, table of 5.3: maintained illuminance of the immediate surrounding area.
double surroundingOf(double task) {
  if (task >= 750) return 500;
  if (task >= 500) return 300;
  if (task >= 300) return 200;
  if (task >= 200) return 150;
  return task;
}

std::vector<analysis::Limit> atLeast(double mean, double u0) {
  return {{"mean_lx", mean, std::nullopt}, {"u0", u0, std::nullopt}};
}

}  // namespace

const std::vector<RequirementPreset>& requirementPresets() {
  static const std::vector<RequirementPreset> presets = readPresets();
  return presets;
}

const RequirementPreset* findRequirementPreset(const std::string& name) {
  const auto& presets = requirementPresets();
  const auto found = std::find_if(presets.begin(), presets.end(), [&](const auto& p) { return p.name == name; });
  return found == presets.end() ? nullptr : &*found;
}

std::vector<std::string> requirementPresetNames() {
  std::vector<std::string> names;
  for (const RequirementPreset& preset : requirementPresets()) names.push_back(preset.name);
  return names;
}

const std::vector<std::string>& requirementAreas() {
  static const std::vector<std::string> areas{"task", "surrounding", "background", "cylindrical", "wall", "ceiling"};
  return areas;
}

std::vector<analysis::Limit> presetLimits(const RequirementPreset& preset, const std::string& area) {
  constexpr double lowUniformity = 0.10;
  std::vector<analysis::Limit> limits;
  if (area == "task") {
    const auto add = [&](const char* key, const std::optional<double>& minimum) {
      if (minimum) limits.push_back({key, minimum, std::nullopt});
    };
    add("mean_lx", preset.mean);
    add("min_lx", preset.minimum);
    add("u0", preset.u0);
    add("ud", preset.ud);
    add("ra", preset.ra);
  } else if (area == "surrounding" && preset.hasSurrounding && preset.mean) {
    return atLeast(surroundingOf(*preset.mean), 0.40);
  } else if (area == "background" && preset.hasSurrounding && preset.mean) {
    return atLeast(surroundingOf(*preset.mean) / 3, lowUniformity);
  } else if (area == "cylindrical" && preset.cylindrical) {
    return atLeast(*preset.cylindrical, lowUniformity);
  } else if (area == "wall" && preset.wall) {
    return atLeast(*preset.wall, lowUniformity);
  } else if (area == "ceiling" && preset.ceiling) {
    return atLeast(*preset.ceiling, lowUniformity);
  }
  return limits;
}

double en12464Spacing(double d) {
  return std::min(10.0, 0.2 * std::pow(5.0, std::log10(d)));
}

std::array<int, 2> en12464Counts(double length, double width) {
  const double longer = std::max(length, width), shorter = std::min(length, width);
  const double d = longer < 2 * shorter ? longer : shorter;
  const int along = std::max(1, static_cast<int>(std::lround(d / en12464Spacing(d))));
  const double spacing = d / along;
  const auto countOf = [&](double edge) {
    return edge == d ? along : std::max(1, static_cast<int>(std::lround(edge / spacing)));
  };
  return {countOf(length), countOf(width)};
}

}  // namespace goniolux::project
