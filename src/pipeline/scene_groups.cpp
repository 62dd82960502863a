#include "pipeline/scene_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/document.h"
#include "core/random.h"
#include "core/sha256.h"

namespace goniolux::pipeline {
namespace {

using core::Estimate;
using core::Value;
using project::GridResult;
using project::Results;

// The document without what only scales results: scenes, dimming levels, requirements.
Value withoutLevels(const Value& value) {
  if (value.isArray()) {
    Value::Array list;
    for (const Value& each : value.array()) list.push_back(withoutLevels(each));
    return list;
  }
  if (!value.isObject()) return value;
  Value::Object members;
  for (const auto& [key, member] : value.object())
    if (key != "dimming" && key != "scenes" && key != "requirements") members.emplace_back(key, withoutLevels(member));
  return members;
}

void collectTexts(const Value& value, std::set<std::string>& texts) {
  if (value.isString()) texts.insert(value.string());
  if (value.isArray())
    for (const Value& each : value.array()) collectTexts(each, texts);
  if (value.isObject())
    for (const auto& [key, member] : value.object()) collectTexts(member, texts);
}

// The document without the spectra of luminaires and of surfaces that emit; their texts, file names among them, are
// collected.
Value withoutLampSpectra(const Value& document, std::set<std::string>& texts) {
  const auto without = [&](const Value& entry) {
    if (!entry.isObject()) return entry;
    Value::Object members;
    for (const auto& [key, member] : entry.object()) {
      if (key == "spectrum")
        collectTexts(member, texts);
      else
        members.emplace_back(key, member);
    }
    return Value(members);
  };
  Value::Object result;
  for (const auto& [key, section] : document.object()) {
    if (key == "luminaires" && section.isArray()) {
      Value::Array list;
      for (const Value& each : section.array()) list.push_back(without(each));
      result.emplace_back(key, list);
    } else if (key == "materials" && section.isObject()) {
      Value::Object list;
      for (const auto& [name, each] : section.object()) list.emplace_back(name, without(each));
      result.emplace_back(key, list);
    } else {
      result.emplace_back(key, section);
    }
  }
  return result;
}

void add(Estimate& sum, const Estimate& part, double level) {
  sum.value += level * part.value;
  sum.statistical = std::hypot(sum.statistical, level * part.statistical);
  for (const auto& [cause, bound] : part.systematic) sum.systematic[cause] += level * bound;
}

Estimate ratio(const Estimate& a, const Estimate& b) {
  Estimate result;
  if (!(b.value > 0)) return result;
  result.value = a.value / b.value;
  const auto relative = [](double part, const Estimate& of) { return of.value > 0 ? part / of.value : 0; };
  result.statistical = result.value * (relative(a.statistical, a) + relative(b.statistical, b));
  for (const Estimate* each : {&a, &b})
    for (const auto& [cause, bound] : each->systematic)
      result.systematic[cause] += result.value * relative(bound, *each);
  return result;
}

void addGrid(GridResult& sum, const GridResult& part, double level) {
  if (sum.points.size() != part.points.size() || sum.excluded != part.excluded) {
    throw core::InputError({}, "groups-differ",
                           fmt::format("the results of the groups have different points in grid \"{}\"; calculate them "
                                       "anew (remove the folder \"groups\")",
                                       sum.name));
  }
  for (std::size_t i = 0; i < sum.values.size(); ++i) {
    sum.values[i] += level * part.values[i];
    for (const auto& [cause, widths] : part.parts) {
      auto& total = sum.parts[cause];
      if (total.empty()) total.assign(sum.values.size(), 0);
      total[i] = cause == "statistical" ? std::hypot(total[i], level * widths[i]) : total[i] + level * widths[i];
    }
  }
  add(sum.mean, part.mean, level);
}

// What follows from the sums: total half-widths, extremes, uniformities.
void finish(GridResult& grid) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  grid.halfWidths.assign(grid.values.size(), 0);
  for (const auto& [cause, widths] : grid.parts)
    for (std::size_t i = 0; i < widths.size(); ++i) grid.halfWidths[i] += widths[i];
  for (const std::size_t i : grid.excluded) {
    grid.values[i] = grid.halfWidths[i] = nan;
    for (auto& [cause, widths] : grid.parts) widths[i] = nan;
  }
  const auto estimateAt = [&](std::size_t i) {
    Estimate estimate;
    estimate.value = grid.values[i];
    for (const auto& [cause, widths] : grid.parts)
      (cause == "statistical" ? estimate.statistical : estimate.systematic[cause]) = widths[i];
    return estimate;
  };
  std::size_t low = grid.values.size(), high = low;
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    if (std::isnan(grid.values[i])) continue;
    if (low == grid.values.size() || grid.values[i] < grid.values[low]) low = i;
    if (high == grid.values.size() || grid.values[i] > grid.values[high]) high = i;
  }
  if (low < grid.values.size()) {
    grid.min = estimateAt(low);
    grid.max = estimateAt(high);
  }
  grid.u0 = ratio(grid.min, grid.mean);
  grid.ud = ratio(grid.min, grid.max);
}

}  // namespace

std::vector<std::string> groupsOf(const project::Project& project) {
  std::vector<std::string> groups;
  for (const scene::Luminaire& luminaire : project.environment.luminaires)
    if (std::find(groups.begin(), groups.end(), luminaire.group) == groups.end()) groups.push_back(luminaire.group);
  const auto emits = [](const material::Material& each) { return each.emission && each.emission->exitance_lm_m2 > 0; };
  const auto& materials = project.environment.materials;
  if (std::any_of(materials.begin(), materials.end(), emits)) groups.emplace_back(emittingSurfaces);
  return groups;
}

project::Project onlyGroup(const project::Project& project, const std::string& group) {
  project::Project alone = project;
  for (scene::Luminaire& luminaire : alone.environment.luminaires) luminaire.dimming = luminaire.group == group ? 1 : 0;
  if (group != emittingSurfaces)
    for (material::Material& each : alone.environment.materials) each.emission.reset();
  alone.requirements.clear();
  alone.observers.clear();
  // Groups draw different random numbers: their errors are independent, as superposed() takes them to be.
  std::uint64_t key = core::mix(project.settings.seed);
  for (const char c : group) key = core::combine(key, static_cast<unsigned char>(c));
  alone.settings.seed = key >> 11;  // below 2^53, as seeds in documents are
  return alone;
}

std::map<std::string, double> dimmingOf(const project::Project& project) {
  std::map<std::string, double> levels;
  for (const scene::Luminaire& luminaire : project.environment.luminaires) {
    const auto [known, isNew] = levels.try_emplace(luminaire.group, luminaire.dimming);
    if (isNew || known->second == luminaire.dimming) continue;
    throw core::InputError(
        luminaire.position, "dimming-within-group",
        fmt::format("the luminaires of the group \"{}\" are dimmed differently ({} and {}); put them "
                    "into groups of their own",
                    luminaire.group, known->second, luminaire.dimming));
  }
  return levels;
}

std::string groupKey(const project::Project& project, LampSpectra spectra) {
  core::Diagnostics ignored;
  Value document = core::parseJson(core::readFile(project.file), project.file, ignored);
  std::set<std::string> lampTexts, otherTexts;
  if (spectra == LampSpectra::doNotMatter) document = withoutLampSpectra(document, lampTexts);
  collectTexts(document, otherTexts);
  std::string text = "2 " + core::toJson(withoutLevels(document));  // 2: emitting surfaces are a group of their own
  for (std::size_t i = 1; i < project.inputs.size(); ++i) {
    const std::string& path = project.inputs[i].path;
    if (!lampTexts.contains(path) || otherTexts.contains(path)) text += project.inputs[i].sha256 + "\n";
  }
  const project::Settings& s = project.settings;
  text += fmt::format("{} {} {} {} {} {} {} {} {}", s.accuracy.grid, s.accuracy.u0, s.accuracy.confidence, s.solver,
                      s.reflectionModel, s.spectralScheme, s.spectralSamples, s.timeLimit_s.value_or(0), s.seed);
  return core::sha256(text);
}

Results superposed(const std::map<std::string, Results>& groups, const std::map<std::string, double>& levels) {
  Results sum = groups.begin()->second;
  sum.requirements.clear();
  sum.wallTime_s = sum.cpuTime_s = 0;
  sum.rays = 0;
  sum.reachedText.clear();
  for (GridResult& grid : sum.grids) {
    std::fill(grid.values.begin(), grid.values.end(), 0.0);
    grid.parts.clear();
    grid.mean = {};
    grid.initialValues.clear();
    grid.initialMean.reset();
    grid.percentiles.clear();
    grid.utilance.reset();
    grid.powerPer100lx.reset();
  }
  sum.power.reset();
  for (const auto& [name, part] : groups) {
    const auto found = levels.find(name);
    const double level = found == levels.end() ? 0 : found->second;
    if (part.grids.size() != sum.grids.size()) {
      throw core::InputError({}, "groups-differ",
                             "the results of the groups have different grids; calculate them anew (remove the folder "
                             "\"groups\")");
    }
    sum.reached = sum.reached && part.reached;
    sum.wallTime_s += part.wallTime_s;
    sum.cpuTime_s += part.cpuTime_s;
    sum.rays += part.rays;
    for (std::size_t i = 0; i < sum.grids.size(); ++i) {
      GridResult clean = part.grids[i];
      for (const std::size_t point : clean.excluded) {
        clean.values[point] = 0;
        for (auto& [cause, widths] : clean.parts) widths[point] = 0;
      }
      addGrid(sum.grids[i], clean, level);
    }
  }
  for (GridResult& grid : sum.grids) finish(grid);
  return sum;
}

}  // namespace goniolux::pipeline
