#include "display/device_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/closest_name.h"

namespace goniolux::display {

using core::Value;

void DeviceSection::complain(const Value& at, const char* rule, std::string message) const {
  diagnostics_.error(at.position(), rule, std::move(message));
}

void DeviceSection::checkKeys(const Value& object, const std::vector<std::string>& known) const {
  for (const auto& [key, value] : object.object()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    diagnostics_.error(value.keyPosition(), "unknown-key",
                       fmt::format("unknown key \"{}\"{}", key, core::suggestion(key, known)));
  }
}

const Value* DeviceSection::member(const Value& object, const char* key, Value::Kind kind, const char* what) const {
  const Value* value = object.find(key);
  if (value == nullptr) {
    complain(object, "missing-key", fmt::format("key \"{}\" is missing", key));
    return nullptr;
  }
  if (value->kind() != kind) {
    complain(*value, "type", fmt::format("\"{}\" must be {}", key, what));
    return nullptr;
  }
  return value;
}

std::string DeviceSection::text(const Value& object, const char* key) const {
  if (object.find(key) == nullptr) return "";
  const Value* value = member(object, key, Value::Kind::string, "a text");
  return value != nullptr ? value->string() : "";
}

spectrum::Chromaticity DeviceSection::chromaticity(const Value& object, const char* key) const {
  const Value* value = member(object, key, Value::Kind::array, "the two CIE chromaticity coordinates [x, y]");
  if (value == nullptr) return {};
  const auto& pair = value->array();
  const bool fits = pair.size() == 2 && pair[0].isNumber() && pair[1].isNumber();
  // Primaries may be imaginary, but y divides and white must be a colour.
  if (!fits || pair[1].number() <= 0 || std::abs(pair[0].number()) > 2 || pair[1].number() > 2) {
    complain(*value, "chromaticity",
             fmt::format("\"{}\" must be the two CIE chromaticity coordinates [x, y], y above 0", key));
    return {};
  }
  return {pair[0].number(), pair[1].number()};
}

double DeviceSection::number(const Value& object, const char* key, double standard, double minimum,
                             double maximum) const {
  if (object.find(key) == nullptr) return standard;
  const Value* value = member(object, key, Value::Kind::number, "a number");
  if (value == nullptr) return standard;
  if (!(value->number() >= minimum && value->number() <= maximum)) {
    complain(*value, "range", fmt::format("\"{}\" must lie between {} and {}", key, minimum, maximum));
  }
  return value->number();
}

}  // namespace goniolux::display
