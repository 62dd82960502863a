#include "reflection/models.h"

#include <algorithm>

#include "reflection/bsdf.h"

namespace goniolux::reflection {

const std::vector<ReflectionModel>& reflectionModels() {
  static const std::vector<ReflectionModel> models = {lambertModel(), mirrorModel()};
  return models;
}

const ReflectionModel* findReflectionModel(const std::string& name) {
  const auto& models = reflectionModels();
  const auto found = std::find_if(models.begin(), models.end(), [&](const auto& m) { return m.name == name; });
  return found == models.end() ? nullptr : &*found;
}

const std::vector<std::string>& plannedReflectionModels() {
  static const std::vector<std::string> names = {"phong",      "whitted",   "hall", "oren-nayar",
                                                 "dielectric", "conductor", "ward"};
  return names;
}

}  // namespace goniolux::reflection
