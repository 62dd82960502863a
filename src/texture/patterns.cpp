#include "texture/patterns.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace goniolux::texture {

const std::vector<PatternType>& patternTypes() {
  static const std::vector<PatternType> types = {checkerPattern(), stripesPattern(), tilesPattern(), noisePattern()};
  return types;
}

const PatternType* findPatternType(const std::string& name) {
  const auto& types = patternTypes();
  const auto found = std::find_if(types.begin(), types.end(), [&](const auto& type) { return type.name == name; });
  return found == types.end() ? nullptr : &*found;
}

core::Parameter number(const char* key, const char* title, double minimum, double maximum, const char* defaultText,
                       const char* help) {
  core::Parameter parameter;
  parameter.key = key;
  parameter.title = title;
  parameter.unit = "1";
  parameter.minimum = minimum;
  parameter.maximum = maximum;
  parameter.defaultText = defaultText;
  parameter.help = help;
  return parameter;
}

double valueOf(const core::Arguments& arguments, const core::Parameter& parameter) {
  const auto found = arguments.find(parameter.key);
  const double* value = found == arguments.end() ? nullptr : std::get_if<double>(&found->second);
  return value != nullptr ? *value : std::strtod(parameter.defaultText.c_str(), nullptr);
}

double fractionOf(double x) {
  const double r = x - std::floor(x);
  return r < 1 ? r : 0;
}

}  // namespace goniolux::texture
