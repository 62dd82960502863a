#include "project/material_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/closest_name.h"
#include "project/format.h"
#include "project/index_reader.h"
#include "project/section_reader.h"
#include "project/spectrum_reader.h"
#include "reflection/bsdf.h"
#include "spectrum/cie_data.h"
#include "spectrum/nk_file.h"

namespace goniolux::project {
namespace {

const MaterialForm* modelOf(const core::Value& value, Reading& reading) {
  std::vector<std::string> names;
  for (const MaterialForm& form : materialForms()) names.push_back(form.model);
  const core::Value* model = value.find("model");
  if (!model) {
    reading.error(value, "missing-key", "a material needs \"model\", e.g. \"lambert\" with \"diffuse\": 0.5");
    return nullptr;
  }
  const auto name = readText(*model, {.name = "model", .form = Form::text}, reading);
  if (!name) return nullptr;
  const auto found = std::find_if(materialForms().begin(), materialForms().end(),
                                  [&](const MaterialForm& form) { return form.model == *name; });
  if (found != materialForms().end()) return &*found;
  reading.error(*model, "unknown-model",
                fmt::format("there is no reflection model \"{}\"{}", *name, core::suggestion(*name, names)));
  return nullptr;
}

std::optional<material::Emission> readEmission(SectionReader& section, Reading& reading) {
  const auto exitance = section.number("exitance_lm_m2");
  if (!exitance) {
    if (section.has("spectrum") && !section.has("exitance_lm_m2")) {
      section.refuse("spectrum", "missing-key",
                     "a material's \"spectrum\" is that of its emission; add \"exitance_lm_m2\"");
    }
    return std::nullopt;
  }
  material::Emission emission{*exitance, spectrum::SpectralDistribution::flat(1)};
  if (const core::Value* spectrum = section.find("spectrum")) {
    const Key key{.name = "spectrum", .minimum = 0};
    auto read = readSpectrum(*spectrum, key, spectrum::Role::source, reading);
    if (!read) return std::nullopt;
    emission.spectrum = std::move(*read);
  }
  return emission;
}

/// n and k of an .nk file: the keys "ior" and "k".
void readComplexIndex(material::Material& material, const Section& form, const std::string& key,
                      const core::Value& given, Reading& reading) {
  if (form.find("k") == nullptr) {
    reading.error(given, "wrong-spectrum",
                  fmt::format("n and k are those of a metal; a \"{}\" has a refractive index only", material.model));
    return;
  }
  const auto path = reading.file(given, Library::materials);
  if (!path) return;
  try {
    spectrum::ComplexIndex index = spectrum::readComplexIndexFile(*path, &reading.diagnostics);
    material.spectra[key] = std::move(index.n);
    material.spectra["k"] = std::move(index.k);
  } catch (const core::InputError& error) {
    reading.adopt(error);
  }
}

void readMaterial(material::Material& material, const core::Value& value, Reading& reading) {
  if (!value.isObject()) {
    reading.error(value, "wrong-type", "a material is an object such as { \"model\": \"lambert\", \"diffuse\": 0.5 }");
    return;
  }
  const MaterialForm* form = modelOf(value, reading);
  if (!form) return;
  material.model = form->model;
  SectionReader section(value, form->section, reading);
  for (const Key& key : form->section.keys) {
    const core::Value* given = section.find(key.name);
    if (!given || key.name == "model" || key.name == "exitance_lm_m2" || key.name == "spectrum" ||
        key.form == Form::section)
      continue;
    if (key.form == Form::number) {
      if (const auto number = section.number(key.name)) material.numbers[key.name] = *number;
    } else if (key.form == Form::boolean) {
      if (const auto flag = section.boolean(key.name)) material.numbers[key.name] = *flag ? 1 : 0;
    } else if (key.form == Form::index && given->isString() &&
               std::filesystem::path(given->string()).extension() == ".nk") {
      readComplexIndex(material, form->section, key.name, *given, reading);
    } else if (key.form == Form::index) {
      if (auto index = readRefractiveIndex(*given, key, reading)) material.spectra[key.name] = std::move(*index);
    } else {
      const auto role = key.form == Form::reflectance ? spectrum::Role::reflectance : spectrum::Role::coefficient;
      if (auto spectrum = readSpectrum(*given, key, role, reading)) material.spectra[key.name] = std::move(*spectrum);
    }
  }
  material.emission = readEmission(section, reading);
  const reflection::ReflectionModel* model = reflection::findReflectionModel(form->model);
  if (section.failed() || model == nullptr || model->complaint == nullptr) return;
  if (const std::string complaint = model->complaint(material); !complaint.empty())
    reading.error(value, "out-of-range", complaint);
}

}  // namespace

std::vector<material::Material> readMaterials(const core::Value& section, Reading& reading) {
  std::vector<material::Material> materials;
  if (!section.isObject()) {
    reading.error(section, "wrong-type", "\"materials\" must be an object: { \"name\": { \"model\": … }, … }");
    return materials;
  }
  for (const auto& [name, value] : section.object()) {
    material::Material& material = materials.emplace_back();
    material.name = name;
    material.position = value.keyPosition();
    readMaterial(material, value, reading);
  }
  return materials;
}

}  // namespace goniolux::project
