#include "project/results.h"

#include <fmt/format.h>
#include <algorithm>

#include <cctype>
#include <cmath>
#include <limits>

namespace goniolux::project {
namespace {

using core::Estimate;
using core::Value;

// A JSON number keeps integers to 2^53 exactly; a larger seed or count is written as text.
Value wholeNumber(std::uint64_t number) {
  constexpr std::uint64_t exactBelow = std::uint64_t{1} << 53;
  return number < exactBelow ? Value(number) : Value(std::to_string(number));
}

Value vector3(const core::Vec3& v) {
  return Value::Array{v.x, v.y, v.z};
}

Value toJson(const Estimate& estimate) {
  Value systematic = Value::Object{};
  for (const auto& [cause, bound] : estimate.systematic) systematic.set(cause, bound);
  Value json;
  json.set("value", estimate.value);
  json.set("half_width", estimate.halfWidth());
  json.set("statistical", estimate.statistical);
  json.set("systematic", systematic);
  return json;
}

Value toJson(const GridResult& grid) {
  Value json;
  json.set("name", grid.name);
  json.set("quantity", grid.quantity);
  json.set("unit", grid.unit);
  if (grid.counts) json.set("counts", Value::Array{(*grid.counts)[0], (*grid.counts)[1]});
  if (grid.plane) {
    json.set("origin", vector3(grid.plane->origin));
    json.set("u", vector3(grid.plane->u));
    json.set("v", vector3(grid.plane->v));
  }
  Value::Array points;
  points.reserve(grid.points.size());
  for (const core::Vec3& point : grid.points) points.push_back(vector3(point));
  json.set("points", std::move(points));
  json.set("values", Value::arrayOf(grid.values));
  json.set("half_widths", Value::arrayOf(grid.halfWidths));
  Value parts = Value::Object{};
  for (const auto& [cause, bounds] : grid.parts) parts.set(cause, Value::arrayOf(bounds));
  json.set("parts", parts);
  Value::Array excluded;
  for (const std::size_t index : grid.excluded) excluded.emplace_back(static_cast<std::uint64_t>(index));
  json.set("excluded", std::move(excluded));
  json.set("mean", toJson(grid.mean));
  json.set("min", toJson(grid.min));
  json.set("max", toJson(grid.max));
  json.set("u0", toJson(grid.u0));
  json.set("ud", toJson(grid.ud));
  if (!grid.percentiles.empty()) {
    Value percentiles = Value::Object{};
    for (const auto& [percent, estimate] : grid.percentiles) percentiles.set(std::to_string(percent), toJson(estimate));
    json.set("percentiles", std::move(percentiles));
  }
  if (grid.utilance) json.set("utilance", toJson(*grid.utilance));
  if (grid.powerPer100lx) json.set("power_density_w_m2_per_100_lx", toJson(*grid.powerPer100lx));
  if (!grid.initialValues.empty() || grid.initialMean) {
    Value initial = Value::Object{};
    if (!grid.initialValues.empty()) initial.set("values", Value::arrayOf(grid.initialValues));
    if (grid.initialMean) initial.set("mean", toJson(*grid.initialMean));
    json.set("initial", initial);
  }
  return json;
}

// A name inside a '#' line must not begin a line of its own.
std::string oneLine(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

// A quantity as the start of a column's name: "melanopic-edi" and "lx" give "melanopic_edi_lx".
std::string columnName(const GridResult& grid) {
  std::string name = grid.unit.empty() ? grid.quantity : grid.quantity + "_" + grid.unit;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

}  // namespace

core::Estimate GridResult::pointEstimate(std::size_t index) const {
  core::Estimate e;
  e.value = values[index];
  const auto statistical = parts.find("statistical");
  e.statistical = statistical == parts.end() ? halfWidths[index] : statistical->second[index];
  e.systematic["all"] = std::max(0.0, halfWidths[index] - e.statistical);
  return e;
}

const char* wordFor(RequirementResult::Verdict verdict) {
  switch (verdict) {
    case RequirementResult::Verdict::pass:
      return "pass";
    case RequirementResult::Verdict::fail:
      return "fail";
    case RequirementResult::Verdict::undecided:
      break;
  }
  return "undecided";
}

std::string tableNumber(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : std::string();
}

Value toJson(const Results& results) {
  Value json;
  json.set("format", "goniolux-results");
  json.set("version", 1);
  json.set("project", results.project);
  json.set("project_hash", results.projectHash);
  json.set("program_version", results.programVersion);
  if (!results.lightingScene.empty()) json.set("scene", results.lightingScene);
  json.set("confidence", results.confidence);
  json.set("seed", wholeNumber(results.seed));
  json.set("settings_used", results.settingsUsed.isObject() ? results.settingsUsed : Value(Value::Object{}));
  json.set("left_out", Value::arrayOf(results.leftOut));
  Value time;
  time.set("wall", results.wallTime_s);
  time.set("cpu", results.cpuTime_s);
  json.set("time_s", time);
  json.set("rays", wholeNumber(results.rays));
  json.set("reached", results.reached);
  json.set("reached_text", results.reachedText);

  Value::Array grids, observers, requirements;
  for (const GridResult& grid : results.grids) grids.push_back(toJson(grid));
  for (const ObserverResult& observer : results.observers) {
    Value entry;
    entry.set("name", observer.name);
    entry.set("quantity", observer.quantity);
    const Value estimate = toJson(observer.value);
    for (const auto& [key, value] : estimate.object()) entry.set(key, value);
    entry.set("eye", vector3(observer.eye));
    entry.set("direction", vector3(observer.direction));
    entry.set("background_cd_m2", toJson(observer.background));
    Value::Array sources;
    for (const GlareSourceResult& source : observer.sources) {
      Value part;
      part.set("luminaire", source.luminaire);
      part.set("luminance_cd_m2", source.luminance);
      part.set("solid_angle_sr", source.solidAngle);
      part.set("position_index", source.positionIndex);
      part.set("share", source.share);
      sources.push_back(std::move(part));
    }
    entry.set("glare_sources", std::move(sources));
    observers.push_back(std::move(entry));
  }
  for (const RequirementResult& requirement : results.requirements) {
    Value entry;
    entry.set("text", requirement.text);
    entry.set("verdict", wordFor(requirement.verdict));
    if (!requirement.of.empty()) entry.set("of", requirement.of);
    if (!requirement.quantity.empty()) entry.set("quantity", requirement.quantity);
    if (requirement.minimum) entry.set("min", *requirement.minimum);
    if (requirement.maximum) entry.set("max", *requirement.maximum);
    if (requirement.found) {
      entry.set("value", requirement.found->value);
      entry.set("half_width", requirement.found->halfWidth());
    }
    if (!requirement.clause.empty()) entry.set("clause", requirement.clause);
    requirements.push_back(std::move(entry));
  }
  json.set("grids", std::move(grids));
  json.set("observers", std::move(observers));
  json.set("requirements", std::move(requirements));
  if (results.power) {
    const LightingPower& power = *results.power;
    const auto orNull = [](const std::optional<double>& number) { return number ? Value(*number) : Value(); };
    Value entry;
    entry.set("flux_lm", power.flux_lm);
    entry.set("connected_load_w", orNull(power.connectedLoad_W));
    entry.set("floor_area_m2", orNull(power.floorArea_m2));
    entry.set("power_density_w_m2", power.density_W_m2 ? toJson(*power.density_W_m2) : Value());
    json.set("lighting_power", std::move(entry));
  }
  Value::Array inputs;
  for (const InputFile& input : results.inputs) {
    Value entry;
    entry.set("path", input.path);
    entry.set("sha256", input.sha256);
    inputs.push_back(std::move(entry));
  }
  if (!inputs.empty()) json.set("inputs", std::move(inputs));
  return json;
}

std::string toCsv(const Results& results, const GridResult& grid) {
  std::string csv = fmt::format("# goniolux {}: {} of grid \"{}\" of project \"{}\"\n", results.programVersion,
                                grid.quantity, oneLine(grid.name), oneLine(results.project));
  csv += fmt::format("# project hash {}; seed {}; half-widths at {:g} % confidence\n", results.projectHash,
                     results.seed, 100 * results.confidence);
  if (!results.lightingScene.empty()) csv += fmt::format("# lighting scene \"{}\"\n", oneLine(results.lightingScene));
  if (!results.reached)
    csv += fmt::format("# the accuracy asked for was not reached: {}\n", oneLine(results.reachedText));
  if (grid.counts)
    csv +=
        fmt::format("# regular grid, {} x {} points, the first count fastest\n", (*grid.counts)[0], (*grid.counts)[1]);
  csv += fmt::format("# mean {:.6g} +- {:.3g} {}; min {:.6g} +- {:.3g} {}; U0 {:.4g} +- {:.2g}\n", grid.mean.value,
                     grid.mean.halfWidth(), grid.unit, grid.min.value, grid.min.halfWidth(), grid.unit, grid.u0.value,
                     grid.u0.halfWidth());
  const std::string unit = grid.unit.empty() ? "" : "_" + grid.unit;
  csv += fmt::format("x_m,y_m,z_m,{},half_width{}\n", columnName(grid), unit);
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    const core::Vec3& p = grid.points[i];
    const double value = i < grid.values.size() ? grid.values[i] : std::numeric_limits<double>::quiet_NaN();
    const double halfWidth = i < grid.halfWidths.size() ? grid.halfWidths[i] : std::numeric_limits<double>::quiet_NaN();
    csv += fmt::format("{:.10g},{:.10g},{:.10g},{},{}\n", p.x, p.y, p.z, tableNumber(value), tableNumber(halfWidth));
  }
  return csv;
}

std::string fileNameFor(const std::string& name) {
  std::string file;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) {
      file += c;  // part of a letter beyond ASCII in UTF-8
    } else if (std::isalnum(byte) != 0) {
      file += static_cast<char>(std::tolower(byte));
    } else {
      file += c == '.' ? '.' : '-';
    }
  }
  // "", "." and ".." would name no file of the folder.
  if (file.find_first_not_of('.') == std::string::npos) file += "-";
  return file;
}

}  // namespace goniolux::project
