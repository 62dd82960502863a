#include "project/baseline.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "core/sha256.h"

namespace goniolux::project {
namespace {

using core::Value;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Fewer digits than a double has: half-widths are never below the fifth digit, and files stay small.
double rounded(double value) {
  if (!std::isfinite(value) || value == 0) return value;
  double back = value;
  const std::string text = fmt::format("{:.7g}", value);
  std::from_chars(text.data(), text.data() + text.size(), back);
  return back;
}

Value numbers(const std::vector<double>& values) {
  Value::Array list;
  list.reserve(values.size());
  for (const double value : values) list.emplace_back(rounded(value));
  return list;
}

Value toJson(const ExpectedValue& expected) {
  Value json;
  json.set(expected.grid.empty() ? "observer" : "grid", expected.grid.empty() ? expected.observer : expected.grid);
  json.set("quantity", expected.quantity);
  if (expected.index) json.set("index", static_cast<double>(*expected.index));
  if (expected.quantity == "points") {
    json.set("values", numbers(expected.values));
    json.set("statistical", numbers(expected.statistical));
    json.set("systematic", numbers(expected.systematic));
  } else {
    json.set("value", rounded(expected.estimate.value));
    json.set("half_width", rounded(expected.estimate.halfWidth()));
    if (expected.own) json.set("statistical", rounded(expected.estimate.statistical));
  }
  json.set("unit", expected.unit);
  if (expected.tolerance) json.set("tolerance", *expected.tolerance);
  if (expected.own) json.set("own", true);
  return json;
}

ExpectedValue single(const std::string& grid, const char* quantity, const std::string& unit, const core::Estimate& e) {
  ExpectedValue value;
  value.grid = grid;
  value.quantity = quantity;
  value.unit = unit;
  value.own = true;
  value.estimate = e;
  return value;
}

ExpectedValue allPoints(const GridResult& grid) {
  ExpectedValue value = single(grid.name, "points", grid.unit, {});
  value.values = grid.values;
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    const core::Estimate e = grid.pointEstimate(i);
    value.statistical.push_back(e.statistical);
    value.systematic.push_back(e.systematic.at("all"));
  }
  return value;
}

}  // namespace

Value toJson(const Baseline& baseline) {
  Value json;
  json.set("format", "goniolux-expected");
  json.set("version", 1);
  json.set("source", baseline.source);
  json.set("confidence", baseline.confidence);
  if (!baseline.tolerances.empty()) {
    Value tolerances = Value::Object{};
    for (const auto& [quantity, tolerance] : baseline.tolerances)
      tolerances.set(quantity, tolerance.relative > 0 ? Value(fmt::format("{:g} %", 100 * tolerance.relative))
                                                      : Value(tolerance.absolute));
    json.set("tolerances", tolerances);
  }
  if (!baseline.programVersion.empty()) {
    json.set("program_version", baseline.programVersion);
    if (baseline.accuracy) json.set("accuracy", fmt::format("{:.4g} %", 100 * *baseline.accuracy));
    json.set("seed", baseline.seed);
    Value::Array inputs;
    for (const InputFile& input : baseline.inputs) {
      Value entry;
      entry.set("path", input.path);
      entry.set("sha256", input.sha256);
      inputs.push_back(std::move(entry));
    }
    json.set("inputs", std::move(inputs));
    Value entries = Value::Object{};
    for (const auto& [name, hash] : baseline.entries) entries.set(name, hash);
    json.set("entries", entries);
  }
  Value::Array values;
  for (const ExpectedValue& value : baseline.values) values.push_back(toJson(value));
  json.set("values", std::move(values));
  return json;
}

std::vector<ExpectedValue> ownValues(const Results& results) {
  std::vector<ExpectedValue> values;
  for (const GridResult& grid : results.grids) {
    values.push_back(single(grid.name, "mean", grid.unit, grid.mean));
    values.push_back(single(grid.name, "min", grid.unit, grid.min));
    values.push_back(single(grid.name, "max", grid.unit, grid.max));
    if (std::isfinite(grid.u0.value)) values.push_back(single(grid.name, "u0", "1", grid.u0));
    values.push_back(allPoints(grid));
  }
  for (const ObserverResult& observer : results.observers) {
    if (!std::isfinite(observer.value.value)) continue;
    ExpectedValue value = single("", observer.quantity.c_str(), "1", observer.value);
    value.observer = observer.name;
    values.push_back(std::move(value));
  }
  return values;
}

std::map<std::string, std::string> entryHashes(const std::string& projectText) {
  std::map<std::string, std::string> hashes;
  core::Diagnostics diagnostics;
  const Value root = core::parseJson(projectText, "project.json", diagnostics);
  if (diagnostics.hasErrors() || !root.isObject()) return hashes;
  const auto add = [&](const std::string& name, const Value& value) {
    hashes[name] = core::sha256(core::toJson(value)).substr(0, 16);
  };
  for (const auto& [key, section] : root.object()) {
    if (key == "materials" && section.isObject()) {
      for (const auto& [name, material] : section.object()) add(fmt::format("{} \"{}\"", key, name), material);
    } else if (section.isArray()) {
      for (std::size_t i = 0; i < section.array().size(); ++i) {
        const Value& entry = section.array()[i];
        const Value* name = entry.find("name");
        add(name && name->isString() ? fmt::format("{} \"{}\"", key, name->string()) : fmt::format("{} {}", key, i + 1),
            entry);
      }
    } else {
      add(key, section);
    }
  }
  return hashes;
}

}  // namespace goniolux::project
