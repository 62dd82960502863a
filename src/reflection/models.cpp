#include "reflection/models.h"

#include <algorithm>
#include <utility>

namespace goniolux::reflection {

const std::vector<ReflectionModel>& reflectionModels() {
  static const std::vector<ReflectionModel> models = {
      lambertModel(), orenNayarModel(),           mirrorModel(), dielectricModel(), conductorModel(),
      wardModel(),    diffuseTransmissionModel(),
  };
  return models;
}

const ReflectionModel* findReflectionModel(const std::string& name) {
  const auto& models = reflectionModels();
  const auto found = std::find_if(models.begin(), models.end(), [&](const auto& m) { return m.name == name; });
  return found == models.end() ? nullptr : &*found;
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

std::string sumComplaint(const material::Material& material, const char* first, const char* second) {
  const auto a = material.spectra.find(first), b = material.spectra.find(second);
  if (a == material.spectra.end() || b == material.spectra.end()) return "";
  for (int nm = 360; nm <= 830; nm += 5)
    if (a->second.continuum(nm) + b->second.continuum(nm) > 1 + 1e-9)
      return std::string("\"") + first + "\" and \"" + second +
             "\" exceed 1 together: more light would leave than arrives; lower one of them";
  return "";
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
