// Reading expected.json: every member is checked before it is believed.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <set>

#include "core/closest_name.h"
#include "project/baseline.h"

namespace goniolux::project {
namespace {

using core::Value;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// "2 %" as 0.02, or a number; nothing when it is neither.
std::optional<double> percentage(const std::string& text) {
  double number = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string tail(rest, text.data() + text.size());
  if (error != std::errc() || !(number >= 0) || (tail != "%" && tail != " %")) return std::nullopt;
  return number / 100;
}

class BaselineReader {
 public:
  Baseline read(const Value& root) {
    Baseline baseline;
    checkFormat(root);
    if (diagnostics_.hasErrors()) throw core::InputError(diagnostics_);
    baseline.source = text(root, "source", false);
    if (root.find("confidence")) baseline.confidence = number(root, "confidence", 0.5, 0.999999);
    baseline.programVersion = text(root, "program_version", false);
    if (const Value* accuracy = root.find("accuracy")) {
      baseline.accuracy = accuracy->isString() ? percentage(accuracy->string()) : std::nullopt;
      if (!baseline.accuracy) complain(*accuracy, "\"accuracy\" must be a percentage such as \"1 %\"");
    }
    if (root.find("seed")) baseline.seed = static_cast<std::uint64_t>(number(root, "seed", 0, 9.007e15));
    if (const Value* tolerances = root.find("tolerances")) readTolerances(*tolerances, baseline);
    readProvenance(root, baseline);
    const Value* values = root.find("values");
    if (!values || !values->isArray()) {
      complain(values ? *values : root, "\"values\" must be a list of what is expected");
    } else {
      for (const Value& entry : values->array()) baseline.values.push_back(value(entry));
    }
    if (diagnostics_.hasErrors()) throw core::InputError(diagnostics_);
    return baseline;
  }

 private:
  void complain(const Value& where, const std::string& what) {
    diagnostics_.error(where.position(), "bad-baseline",
                       what + "; mend it, or make it anew with `goniolux verify --update`");
  }

  void checkFormat(const Value& root) {
    const Value* format = root.find("format");
    if (!format || !format->isString() || format->string() != "goniolux-expected") {
      complain(format ? *format : root, "no baseline: \"format\": \"goniolux-expected\" is missing");
      return;
    }
    const Value* version = root.find("version");
    if (!version || !version->isNumber() || version->number() != 1)
      complain(version ? *version : *format, "this program reads \"version\": 1 of baselines");
  }

  std::string text(const Value& object, const char* key, bool required) {
    const Value* value = object.find(key);
    if (value && value->isString()) return value->string();
    if (value || required) complain(value ? *value : object, fmt::format("\"{}\" must be a text", key));
    return {};
  }

  double number(const Value& object, const char* key, double minimum, double maximum) {
    const Value* value = object.find(key);
    if (value && value->isNumber() && value->number() >= minimum && value->number() <= maximum) return value->number();
    complain(value ? *value : object, fmt::format("\"{}\" must be a number from {:g} to {:g}", key, minimum, maximum));
    return minimum;
  }

  std::vector<double> numbers(const Value& object, const char* key) {
    std::vector<double> list;
    const Value* values = object.find(key);
    if (!values || !values->isArray()) {
      complain(values ? *values : object, fmt::format("\"{}\" must be a list of numbers", key));
      return list;
    }
    for (const Value& entry : values->array()) {
      if (!entry.isNumber() && !entry.isNull()) complain(entry, fmt::format("\"{}\" must hold numbers or null", key));
      list.push_back(entry.isNumber() ? entry.number() : nan);
    }
    return list;
  }

  ExpectedValue value(const Value& entry) {
    static const std::vector<std::string> ofGrids{"mean", "min", "max", "u0", "ud", "point", "points"};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    ExpectedValue expected;
    expected.grid = text(entry, "grid", false);
    expected.observer = text(entry, "observer", false);
    if (expected.grid.empty() == expected.observer.empty())
      complain(entry, "a value is about either a \"grid\" or an \"observer\"");
    expected.quantity = text(entry, "quantity", true);
    if (!expected.grid.empty() && std::find(ofGrids.begin(), ofGrids.end(), expected.quantity) == ofGrids.end())
      complain(entry, fmt::format("there is no quantity \"{}\" of a grid{}", expected.quantity,
                                  core::suggestion(expected.quantity, ofGrids)));
    expected.unit = text(entry, "unit", false);
    if (const Value* own = entry.find("own")) expected.own = own->isBoolean() && own->boolean();
    if (entry.find("tolerance")) expected.tolerance = number(entry, "tolerance", 0, infinity);
    if (expected.quantity == "points") {
      expected.values = numbers(entry, "values");
      expected.statistical = numbers(entry, "statistical");
      expected.systematic = numbers(entry, "systematic");
      if (expected.statistical.size() != expected.values.size() || expected.systematic.size() != expected.values.size())
        complain(entry, "\"values\", \"statistical\" and \"systematic\" must be of one length");
      return expected;
    }
    if (expected.quantity == "point") expected.index = static_cast<std::size_t>(number(entry, "index", 0, 1e9));
    expected.estimate.value = number(entry, "value", -infinity, infinity);
    const double halfWidth = number(entry, "half_width", 0, infinity);
    expected.estimate.statistical = halfWidth;
    if (entry.find("statistical")) {
      expected.estimate.statistical = number(entry, "statistical", 0, infinity);
      if (halfWidth > expected.estimate.statistical)
        expected.estimate.systematic["all"] = halfWidth - expected.estimate.statistical;
    }
    return expected;
  }

  void readTolerances(const Value& tolerances, Baseline& baseline) {
    if (!tolerances.isObject())
      return complain(tolerances, "\"tolerances\" must be an object: { \"mean\": \"0.5 %\", … }");
    for (const auto& [quantity, limit] : tolerances.object()) {
      const auto relative = limit.isString() ? percentage(limit.string()) : std::nullopt;
      if (relative) {
        baseline.tolerances[quantity] = {*relative, 0};
      } else if (limit.isNumber() && limit.number() >= 0) {
        baseline.tolerances[quantity] = {0, limit.number()};
      } else {
        complain(limit, "a tolerance is a percentage such as \"0.5 %\", or a number in the quantity's unit");
      }
    }
  }

  void readProvenance(const Value& root, Baseline& baseline) {
    if (const Value* inputs = root.find("inputs"); inputs && inputs->isArray()) {
      for (const Value& input : inputs->array())
        baseline.inputs.push_back({text(input, "path", true), text(input, "sha256", true)});
    }
    if (const Value* entries = root.find("entries"); entries && entries->isObject()) {
      for (const auto& [name, hash] : entries->object())
        if (hash.isString()) baseline.entries[name] = hash.string();
    }
  }

  core::Diagnostics diagnostics_;
};

}  // namespace

Baseline readBaseline(const std::string& file) {
  core::Diagnostics diagnostics;
  const Value root = core::parseJson(core::readFile(file), file, diagnostics);
  if (diagnostics.hasErrors()) throw core::InputError(diagnostics);
  Baseline baseline = BaselineReader().read(root);
  baseline.file = file;
  return baseline;
}

}  // namespace goniolux::project
