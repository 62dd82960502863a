#include "app/gui/forms/sections.h"

#include <fmt/format.h>

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

#include "app/gui/document/json_pointer.h"
#include "geometry/objects.h"

namespace goniolux::gui {
namespace {

using core::Value;
using project::Form;
using project::Key;
using project::Section;
using Shared = std::shared_ptr<const Section>;

/// A table that lives as long as the program.
Shared lasting(const Section& section) {
  return {Shared(), &section};
}

std::string textOf(const Value& value, const char* key) {
  const Value* text = value.find(key);
  return text != nullptr && text->isString() ? text->string() : std::string();
}

Shared materialSection(const Value& material) {
  const std::string model = textOf(material, "model");
  for (const project::MaterialForm& form : project::materialForms())
    if (form.model == model) {
      // The registry's names are the choices of "model".
      auto section = std::make_shared<Section>(form.section);
      for (Key& key : section->keys)
        if (key.name == "model")
          for (const project::MaterialForm& other : project::materialForms()) key.choices.push_back(other.model);
      return section;
    }
  return nullptr;
}

Shared objectSection(const Value& object) {
  const std::string shape = textOf(object, "shape");
  if (shape == "group") return std::make_shared<const Section>(project::groupSection());
  const geometry::ObjectType* type = geometry::findObjectType(shape);
  return type != nullptr ? std::make_shared<const Section>(project::objectSection(*type)) : nullptr;
}

}  // namespace

std::shared_ptr<const Section> sectionAt(const Value& root, const std::string& pointer) {
  Shared section = lasting(project::rootSection());
  const Value* value = &root;
  const std::vector<std::string> steps = stepsOf(pointer);
  std::string place;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Key* key = section->find(steps[i]);
    if (key == nullptr) return nullptr;
    place = under(place, steps[i]);
    const bool isList = key->form == Form::sections || key->form == Form::objects || key->form == Form::materials;
    if (isList) {
      if (++i == steps.size()) return nullptr;
      place = under(place, steps[i]);
    }
    value = valueAt(root, place);
    const Form form = key->form;
    if (form == Form::section || form == Form::sections) {
      section = key->section != nullptr ? lasting(*key->section) : nullptr;
    } else if (form == Form::objects) {
      section = value != nullptr ? objectSection(*value) : nullptr;
    } else if (form == Form::materials) {
      section = value != nullptr ? materialSection(*value) : nullptr;
    } else {
      section = nullptr;
    }
    if (!section) return nullptr;
  }
  return section;
}

std::string labelOf(const std::string& key) {
  std::string label = key;
  std::replace(label.begin(), label.end(), '_', ' ');
  for (const char* unit : {" lm m2", " s", " lx", " cd", " m"})
    if (label.ends_with(unit)) return label.substr(0, label.size() - std::string(unit).size());
  return label;
}

QString translatedLabelOf(const std::string& key) {
  return QCoreApplication::translate("format", labelOf(key).c_str());
}

std::string unitOf(const Key& key, const std::string& projectUnits) {
  if (!key.unit.empty()) return key.unit == "m" ? projectUnits : key.unit == "1" ? std::string() : key.unit;
  switch (key.form) {
    case Form::length:
    case Form::point:
      return projectUnits;
    default:
      break;
  }
  if (key.name.ends_with("_s")) return "s";
  if (key.name.ends_with("_lx")) return "lx";
  return {};
}

std::string explanationOf(const Key& key) {
  std::string text = key.name + ": " + key.help;  // the key as the file names it, whatever the language
  const bool hasLow = std::isfinite(key.minimum), hasHigh = std::isfinite(key.maximum) && key.maximum < 1e15;
  if (hasLow && hasHigh) {
    text += fmt::format("; {} {:g} to {:g}", key.minimumIsAllowed ? "from" : "above", key.minimum, key.maximum);
  } else if (hasLow) {
    text += fmt::format("; {} {:g}", key.minimumIsAllowed ? "at least" : "above", key.minimum);
  } else if (hasHigh) {
    text += fmt::format("; at most {:g}", key.maximum);
  }
  if (key.required) text += "; needed";
  return text;
}

}  // namespace goniolux::gui
