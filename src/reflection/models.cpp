#include "reflection/models.h"

#include <algorithm>
#include <utility>

namespace goniolux::reflection {

const std::vector<ReflectionModel>& reflectionModels() {
  static const std::vector<ReflectionModel> models = {
      lambertModel(),
      orenNayarModel(),
      mirrorModel(),
      dielectricModel(),
  };
  return models;
}

const ReflectionModel* findReflectionModel(const std::string& name) {
  const auto& models = reflectionModels();
  const auto found = std::find_if(models.begin(), models.end(), [&](const auto& m) { return m.name == name; });
  return found == models.end() ? nullptr : &*found;
}

const std::vector<std::string>& plannedReflectionModels() {
  static const std::vector<std::string> names = {"phong", "whitted", "hall", "conductor", "ward"};
  return names;
}

core::Parameter fraction(std::string key, std::string title, bool required, std::string help, std::string source) {
  core::Parameter parameter;
  parameter.key = std::move(key);
  parameter.title = std::move(title);
  parameter.unit = "1";
  parameter.kind = core::ParameterKind::spectrum;
  parameter.required = required;
  parameter.minimum = 0;
  parameter.maximum = 1;
  parameter.help = std::move(help);
  parameter.source = std::move(source);
  return parameter;
}

core::Parameter plainNumber(std::string key, std::string title, double minimum, double maximum, std::string help) {
  core::Parameter parameter;
  parameter.key = std::move(key);
  parameter.title = std::move(title);
  parameter.unit = "1";
  parameter.minimum = minimum;
  parameter.maximum = maximum;
  parameter.help = std::move(help);
  return parameter;
}

}  // namespace goniolux::reflection
