#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/closest_name.h"
#include "core/diagnostics.h"
#include "core/text.h"
#include "display/mapping.h"
#include "display/mapping_types.h"

namespace goniolux::display {
namespace {

[[noreturn]] void refuse(std::string message) {
  throw core::InputError({}, "mapping", std::move(message));
}

core::Argument valueOf(const core::Parameter& parameter, const std::string& text, const std::string& mapping) {
  if (parameter.kind == core::ParameterKind::text) return text;
  if (parameter.kind == core::ParameterKind::boolean) {
    if (text.empty() || text == "yes") return 1.0;
    if (text == "no") return 0.0;
    refuse(fmt::format("'{}' of {} is yes or no, not '{}'", parameter.key, mapping, text));
  }
  const auto value = core::parseNumber(text);
  const bool fits = value && std::isfinite(*value) && *value <= parameter.maximum &&
                    (parameter.minimumIsAllowed ? *value >= parameter.minimum : *value > parameter.minimum);
  if (!fits)
    refuse(fmt::format("'{}' of {} must be a number{}{}, not '{}'", parameter.key, mapping,
                       parameter.minimumIsAllowed ? " from " : " above ", parameter.minimum, text));
  return *value;
}

}  // namespace

const std::vector<MappingType>& mappingTypes() {
  static const std::vector<MappingType> list{
      linearMapping(), absoluteMapping(), tumblinRushmeierMapping(),
      wardMapping(),   reinhardMapping(), falseColourMapping(),
  };
  return list;
}

MappingChoice mappingNamed(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string name = core::lowerCase(text.substr(0, colon));
  const auto found = std::find_if(mappingTypes().begin(), mappingTypes().end(),
                                  [&](const MappingType& type) { return type.name == name; });
  if (found == mappingTypes().end()) {
    std::vector<std::string> names;
    for (const MappingType& type : mappingTypes()) names.push_back(type.name);
    refuse(fmt::format("there is no mapping '{}'{}", name, core::suggestion(name, names)));
  }
  MappingChoice choice{&*found, {}};
  std::vector<std::string> keys;
  for (const core::Parameter& parameter : found->parameters) {
    choice.arguments[parameter.key] = valueOf(parameter, parameter.defaultText, name);
    keys.push_back(parameter.key);
  }
  for (std::size_t at = colon; at != std::string::npos;) {
    const std::size_t begin = at + 1;
    at = text.find(',', begin);
    const std::string piece = text.substr(begin, at == std::string::npos ? at : at - begin);
    if (piece.empty()) continue;
    const std::size_t sign = piece.find('=');
    const std::string key = piece.substr(0, sign);
    const auto parameter = std::find_if(found->parameters.begin(), found->parameters.end(),
                                        [&](const core::Parameter& each) { return each.key == key; });
    if (parameter == found->parameters.end())
      refuse(keys.empty() ? fmt::format("the mapping '{}' takes nothing after a colon", name)
                          : fmt::format("'{}' is nothing that the mapping '{}' knows{}", key, name,
                                        core::suggestion(key, keys)));
    choice.arguments[key] = valueOf(*parameter, sign == std::string::npos ? "" : piece.substr(sign + 1), name);
  }
  return choice;
}

}  // namespace goniolux::display
