// Reading grids.json: every member is checked before it is believed.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>

#include "project/results.h"

namespace goniolux::project {
namespace {

using core::Diagnostics;
using core::Estimate;
using core::Value;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class Reader {
 public:
  Results read(const Value& document) {
    Results results;
    if (!document.isObject()) {
      complain(document, "no results: an object with \"format\": \"goniolux-results\" is expected");
      throw core::InputError(diagnostics_);
    }
    checkFormat(document);
    if (diagnostics_.hasErrors()) throw core::InputError(diagnostics_);

    results.project = text(document, "project", true);
    results.projectHash = text(document, "project_hash", false);
    results.programVersion = text(document, "program_version", false);
    results.lightingScene = text(document, "scene", false);
    results.confidence = number(document, "confidence", 0, 1);
    results.seed = wholeNumber(document, "seed", 1);
    results.rays = wholeNumber(document, "rays", 0);
    results.reachedText = text(document, "reached_text", false);
    if (const Value* reached = document.find("reached")) {
      if (reached->isBoolean()) {
        results.reached = reached->boolean();
      } else {
        complain(*reached, "\"reached\" must be true or false");
      }
    }
    if (const Value* settings = document.find("settings_used"); settings && settings->isObject()) {
      results.settingsUsed = *settings;
    }
    for (const Value& sentence : list(document, "left_out", false)) {
      if (sentence.isString()) {
        results.leftOut.push_back(sentence.string());
      } else {
        complain(sentence, "\"left_out\" must hold sentences");
      }
    }
    if (const Value* time = document.find("time_s"); time && time->isObject()) {
      results.wallTime_s = number(*time, "wall", 0, infinity);
      results.cpuTime_s = number(*time, "cpu", 0, infinity);
    }
    for (const Value& entry : list(document, "grids", true)) results.grids.push_back(grid(entry));
    for (const Value& entry : list(document, "observers", false)) results.observers.push_back(observer(entry));
    for (const Value& entry : list(document, "requirements", false)) results.requirements.push_back(requirement(entry));
    if (const Value* power = document.find("lighting_power"); power && power->isObject())
      results.power = lightingPower(*power);
    for (const Value& entry : list(document, "inputs", false))
      results.inputs.push_back({text(entry, "path", true), text(entry, "sha256", true)});
    if (diagnostics_.hasErrors()) throw core::InputError(diagnostics_);
    return results;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void complain(const Value& where, const std::string& what) {
    diagnostics_.error(where.position(), "damaged-results",
                       what + "; make the results again with `goniolux illuminate`");
  }

  void checkFormat(const Value& document) {
    const Value* format = document.find("format");
    if (!format || !format->isString() || format->string() != "goniolux-results") {
      complain(format ? *format : document, "this is no results file: \"format\": \"goniolux-results\" is missing");
      return;
    }
    const Value* version = document.find("version");
    if (!version || !version->isNumber()) {
      complain(version ? *version : document, "\"version\" is missing");
    } else if (version->number() != 1) {
      diagnostics_.error(
          version->position(), "results-version",
          fmt::format("results version {:g} is newer than this program, which reads version 1; use the program "
                      "that made them",
                      version->number()));
    }
  }

  std::string text(const Value& object, std::string_view key, bool required) {
    const Value* value = object.find(key);
    if (!value) {
      if (required) complain(object, fmt::format("\"{}\" is missing", key));
      return {};
    }
    if (!value->isString()) {
      complain(*value, fmt::format("\"{}\" must be text", key));
      return {};
    }
    return value->string();
  }

  double number(const Value& object, std::string_view key, double minimum, double maximum) {
    const Value* value = object.find(key);
    if (!value) {
      complain(object, fmt::format("\"{}\" is missing", key));
      return 0;
    }
    if (!value->isNumber() || !(value->number() >= minimum && value->number() <= maximum)) {
      complain(*value, maximum < infinity
                           ? fmt::format("\"{}\" must be a number from {:g} to {:g}", key, minimum, maximum)
                           : fmt::format("\"{}\" must be a number not below {:g}", key, minimum));
      return 0;
    }
    return value->number();
  }

  std::uint64_t wholeNumber(const Value& object, std::string_view key, std::uint64_t fallback) {
    const Value* value = object.find(key);
    if (!value) return fallback;
    constexpr double exactBelow = 9007199254740992.0;  // 2^53
    if (value->isNumber() && value->number() >= 0 && value->number() <= exactBelow &&
        value->number() == std::floor(value->number())) {
      return static_cast<std::uint64_t>(value->number());
    }
    if (value->isString()) {
      const std::string& digits = value->string();
      std::uint64_t result = 0;
      const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), result);
      if (error == std::errc() && end == digits.data() + digits.size()) return result;
    }
    complain(*value, fmt::format("\"{}\" must be a whole number, not negative", key));
    return fallback;
  }

  const Value::Array& list(const Value& object, std::string_view key, bool required) {
    static const Value::Array none;
    const Value* value = object.find(key);
    if (!value) {
      if (required) complain(object, fmt::format("\"{}\" is missing", key));
      return none;
    }
    if (!value->isArray()) {
      complain(*value, fmt::format("\"{}\" must be a list", key));
      return none;
    }
    return value->array();
  }

  core::Vec3 vector3(const Value& value, std::string_view what) {
    core::Vec3 result{0};
    const bool good = value.isArray() && value.array().size() == 3;
    for (int i = 0; good && i < 3; ++i) {
      const Value& component = value.array()[static_cast<std::size_t>(i)];
      if (!component.isNumber()) {
        complain(component, fmt::format("{} must be three numbers", what));
        return result;
      }
      result[i] = component.number();
    }
    if (!good) complain(value, fmt::format("{} must be three numbers", what));
    return result;
  }

  Estimate estimateMembers(const Value& value) {
    Estimate estimate;
    estimate.value = number(value, "value", -infinity, infinity);
    const double halfWidth = number(value, "half_width", 0, infinity);
    if (const Value* systematic = value.find("systematic"); systematic && systematic->isObject()) {
      for (const auto& [cause, bound] : systematic->object()) {
        estimate.systematic[cause] = number(*systematic, cause, 0, infinity);
      }
    }
    // The parts make the total; a file that gives only the total has it all statistical.
    if (!value.find("statistical")) {
      estimate.systematic.clear();
      estimate.statistical = halfWidth;
      return estimate;
    }
    estimate.statistical = number(value, "statistical", 0, infinity);
    if (std::abs(estimate.halfWidth() - halfWidth) > 1e-9 * halfWidth) {
      complain(value,
               fmt::format("\"half_width\" is {:g}, but its parts sum to {:g}", halfWidth, estimate.halfWidth()));
    }
    return estimate;
  }

  Estimate estimate(const Value& object, std::string_view key) {
    const Value* value = object.find(key);
    if (!value || !value->isObject()) {
      complain(value ? *value : object, fmt::format("\"{}\" with \"value\" and \"half_width\" is missing", key));
      return {};
    }
    return estimateMembers(*value);
  }

  /// Null where no light arrives (U0 and Ud: 0/0) and in an interrupted run.
  Estimate ratio(const Value& object, std::string_view key) {
    const Value* json = object.find(key);
    if (const Value* value = json ? json->find("value") : nullptr; value && value->isNull()) return {nan, nan, {}};
    return estimate(object, key);
  }

  /// One number per point; null (NaN here) exactly where the point is excluded.
  std::vector<double> perPoint(const Value& where, const Value::Array& values, std::string_view what, double minimum,
                               const std::vector<bool>& isExcluded) {
    std::vector<double> result;
    if (values.size() != isExcluded.size()) {
      complain(where, fmt::format("{} holds {} values for {} points", what, values.size(), isExcluded.size()));
      return std::vector<double>(isExcluded.size(), nan);
    }
    result.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Value& value = values[i];
      const bool good = isExcluded[i] ? value.isNull() : value.isNumber() && value.number() >= minimum;
      if (!good) {
        complain(value, isExcluded[i] ? fmt::format("{}: point {} is excluded and must be null", what, i)
                                      : fmt::format("{}: point {} must be a number not below {:g}", what, i, minimum));
        return std::vector<double>(isExcluded.size(), nan);
      }
      result.push_back(value.isNumber() ? value.number() : nan);
    }
    return result;
  }

  std::vector<double> perPoint(const Value& object, const std::string& key, double minimum,
                               const std::vector<bool>& isExcluded) {
    return perPoint(object, list(object, key, true), "\"" + key + "\"", minimum, isExcluded);
  }

  GridResult grid(const Value& json) {
    GridResult grid;
    if (!json.isObject()) {
      complain(json, "a grid must be an object");
      return grid;
    }
    grid.name = text(json, "name", true);
    grid.quantity = text(json, "quantity", true);
    grid.unit = text(json, "unit", true);
    for (const Value& point : list(json, "points", true)) grid.points.push_back(vector3(point, "a point"));
    counts(json, grid);
    if (json.find("origin") && json.find("u") && json.find("v")) {
      grid.plane = GridPlane{vector3(*json.find("origin"), "\"origin\""), vector3(*json.find("u"), "\"u\""),
                             vector3(*json.find("v"), "\"v\"")};
    }
    std::vector<bool> isExcluded(grid.points.size(), false);
    for (const Value& index : list(json, "excluded", false)) {
      const bool good = index.isNumber() && index.number() >= 0 && index.number() == std::floor(index.number()) &&
                        index.number() < static_cast<double>(grid.points.size());
      if (!good) {
        complain(index, "\"excluded\" must hold indices of points");
        continue;
      }
      grid.excluded.push_back(static_cast<std::size_t>(index.number()));
      isExcluded[grid.excluded.back()] = true;
    }
    grid.values = perPoint(json, "values", -infinity, isExcluded);
    grid.halfWidths = perPoint(json, "half_widths", 0, isExcluded);
    if (const Value* parts = json.find("parts"); parts && parts->isObject()) {
      for (const auto& [cause, values] : parts->object()) grid.parts[cause] = perPoint(*parts, cause, 0, isExcluded);
    }
    grid.mean = estimate(json, "mean");
    grid.min = estimate(json, "min");
    grid.max = estimate(json, "max");
    grid.u0 = ratio(json, "u0");
    grid.ud = ratio(json, "ud");
    if (const Value* percentiles = json.find("percentiles"); percentiles && percentiles->isObject())
      for (const auto& [percent, value] : percentiles->object()) {
        int number = 0;
        const auto [end, error] = std::from_chars(percent.data(), percent.data() + percent.size(), number);
        if (error != std::errc() || end != percent.data() + percent.size() || number < 0 || number > 100)
          complain(value, "\"percentiles\" must be named by whole numbers from 0 to 100");
        else
          grid.percentiles[number] = ratio(*percentiles, percent);
      }
    if (json.find("utilance")) grid.utilance = estimate(json, "utilance");
    if (json.find("power_density_w_m2_per_100_lx"))
      grid.powerPer100lx = estimate(json, "power_density_w_m2_per_100_lx");
    if (const Value* initial = json.find("initial"); initial && initial->isObject()) {
      if (initial->find("values")) grid.initialValues = perPoint(*initial, "values", -infinity, isExcluded);
      if (initial->find("mean")) grid.initialMean = estimate(*initial, "mean");
    }
    return grid;
  }

  LightingPower lightingPower(const Value& json) {
    const auto orNothing = [&](const char* key) -> std::optional<double> {
      const Value* value = json.find(key);
      return value && !value->isNull() ? std::optional(number(json, key, 0, infinity)) : std::nullopt;
    };
    LightingPower power;
    power.flux_lm = number(json, "flux_lm", 0, infinity);
    power.connectedLoad_W = orNothing("connected_load_w");
    power.floorArea_m2 = orNothing("floor_area_m2");
    if (const Value* density = json.find("power_density_w_m2"); density && !density->isNull())
      power.density_W_m2 = estimate(json, "power_density_w_m2");
    return power;
  }

  void counts(const Value& json, GridResult& grid) {
    const Value* counts = json.find("counts");
    if (!counts || counts->isNull()) return;
    const auto whole = [](const Value& v) {
      return v.isNumber() && v.number() >= 1 && v.number() <= 1e6 && v.number() == std::floor(v.number());
    };
    if (!counts->isArray() || counts->array().size() != 2 || !whole(counts->array()[0]) || !whole(counts->array()[1])) {
      complain(*counts, "\"counts\" must be two whole numbers");
      return;
    }
    const double along = counts->array()[0].number(), across = counts->array()[1].number();
    if (along * across != static_cast<double>(grid.points.size())) {
      complain(*counts,
               fmt::format("\"counts\" gives {:g} points, but there are {}", along * across, grid.points.size()));
      return;
    }
    grid.counts = {static_cast<int>(along), static_cast<int>(across)};
  }

  ObserverResult observer(const Value& json) {
    if (!json.isObject()) {
      complain(json, "an observer must be an object");
      return {};
    }
    ObserverResult observer;
    observer.name = text(json, "name", true);
    observer.quantity = text(json, "quantity", true);
    const Value* value = json.find("value");  // null: a rating without background, or an interrupted run
    observer.value = value != nullptr && value->isNull() ? Estimate{nan, nan, {}} : estimateMembers(json);
    if (const Value* eye = json.find("eye")) observer.eye = vector3(*eye, "an eye");
    if (const Value* direction = json.find("direction")) observer.direction = vector3(*direction, "a direction");
    if (json.find("background_cd_m2")) observer.background = ratio(json, "background_cd_m2");
    for (const Value& entry : list(json, "glare_sources", false)) {
      if (!entry.isObject()) {
        complain(entry, "a glare source must be an object");
        continue;
      }
      observer.sources.push_back({text(entry, "luminaire", true), number(entry, "luminance_cd_m2", 0, infinity),
                                  number(entry, "solid_angle_sr", 0, infinity),
                                  number(entry, "position_index", 0, infinity), number(entry, "share", 0, 1.000001)});
    }
    return observer;
  }

  RequirementResult requirement(const Value& json) {
    RequirementResult result;
    if (!json.isObject()) {
      complain(json, "a requirement must be an object");
      return result;
    }
    result.text = text(json, "text", true);
    const std::string verdict = text(json, "verdict", true);
    if (verdict == "pass") {
      result.verdict = RequirementResult::Verdict::pass;
    } else if (verdict == "fail") {
      result.verdict = RequirementResult::Verdict::fail;
    } else if (verdict != "undecided") {
      complain(json, "\"verdict\" must be pass, fail or undecided");
    }
    result.of = text(json, "of", false);
    result.quantity = text(json, "quantity", false);
    result.clause = text(json, "clause", false);
    if (json.find("min")) result.minimum = number(json, "min", -infinity, infinity);
    if (json.find("max")) result.maximum = number(json, "max", -infinity, infinity);
    if (const Value* value = json.find("value"); value && value->isNumber()) result.found = estimateMembers(json);
    return result;
  }

  Diagnostics diagnostics_;
};

}  // namespace

Results resultsFromJson(const Value& document) {
  return Reader().read(document);
}

Results readResults(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  std::string file = path;
  if (fs::is_directory(path, ignored)) {
    file = (fs::path(path) / resultsFileName).string();
    if (!fs::exists(file, ignored)) {
      throw core::InputError(
          {path}, "no-results",
          fmt::format("this folder holds no {}; calculate first with `goniolux illuminate PROJECT -o {}`",
                      resultsFileName, path));
    }
  }
  Diagnostics diagnostics;
  const Value document = core::parseJson(core::readFile(file), file, diagnostics);
  if (diagnostics.hasErrors()) throw core::InputError(diagnostics);
  return resultsFromJson(document);
}

}  // namespace goniolux::project
