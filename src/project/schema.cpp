#include "project/schema.h"

#include <cmath>
#include <string>

#include "project/format.h"
#include "spectrum/cie_data.h"

namespace goniolux::project {
namespace {

using core::Value;

Value object(Value::Object members) {
  return Value(std::move(members));
}
Value type(const char* name) {
  return object({{"type", name}});
}
Value reference(const std::string& name) {
  return object({{"$ref", "#/$defs/" + name}});
}
Value anyOf(Value::Array options) {
  return object({{"anyOf", std::move(options)}});
}
Value texts(const std::vector<std::string>& list) {
  return object({{"enum", Value::arrayOf(list)}});
}

Value listOf(Value items, int least = 1) {
  return object({{"type", "array"}, {"items", std::move(items)}, {"minItems", least}});
}

Value tuple(int size, const char* ofType = "number") {
  return object({{"type", "array"}, {"items", type(ofType)}, {"minItems", size}, {"maxItems", size}});
}

Value mapOf(Value values) {
  return object({{"type", "object"}, {"additionalProperties", std::move(values)}});
}

/// A number within the key's limits.
Value number(const Key& key, const char* typeName = "number") {
  Value schema = type(typeName);
  if (std::isfinite(key.minimum)) schema.set(key.minimumIsAllowed ? "minimum" : "exclusiveMinimum", key.minimum);
  if (std::isfinite(key.maximum)) schema.set("maximum", key.maximum);
  return schema;
}

Value sectionSchema(const Section& section);

Value valueSchema(const Key& key) {
  switch (key.form) {
    case Form::number:
    case Form::length:
      return number(key);
    case Form::numberOrNull:
      return anyOf({number(key), type("null")});
    case Form::integer:
      return number(key, "integer");
    case Form::boolean:
      return type("boolean");
    case Form::text:
    case Form::file:
      return type("string");
    case Form::choice:
      return texts(key.choices);
    case Form::point:
    case Form::direction:
      return reference("vector");
    case Form::points:
    case Form::directions:
      return listOf(reference("vector"));
    case Form::profile:
    case Form::curve:
      return listOf(tuple(2));
    case Form::faces:
      return listOf(listOf(type("integer")));
    case Form::loops:
      return listOf(listOf(reference("vector")), 0);
    case Form::counts:
      return tuple(2, "integer");
    case Form::percentage:
      return anyOf({object({{"type", "string"}, {"pattern", "^[0-9.eE+-]+ *%? *$"}}),
                    object({{"type", "number"}, {"exclusiveMinimum", 0}, {"exclusiveMaximum", 1}})});
    case Form::reflectance:
    case Form::source:
    case Form::quantity:
      return anyOf({number(key), reference("spectrum")});
    case Form::index:
      return anyOf({number(key), reference("spectrum"), sectionSchema(dispersionSection())});
    case Form::numbers:
      return listOf(type("number"));
    case Form::section:
      return sectionSchema(*key.section);
    case Form::sections:
      return listOf(sectionSchema(*key.section), 0);
    case Form::numberMap:
      return mapOf(number(key));
    case Form::materials:
      return mapOf(reference("material"));
    case Form::objects:
      return listOf(reference("object"));
    case Form::partMaterials:
      return mapOf(type("string"));
    case Form::transform:
      return listOf(sectionSchema(transformStepSection()), 0);
    case Form::scale:
      return anyOf({number(key), tuple(3)});
    case Form::photometry:
      return anyOf({type("string"), sectionSchema(photometrySection())});
    case Form::opening:
      return reference("opening");
    case Form::fieldOfView:
      return anyOf({number(key), sectionSchema(horizontalFieldSection())});
    case Form::spectral:
      return anyOf({type("string"), sectionSchema(spectralSection())});
  }
  return object({});
}

Value sectionSchema(const Section& section) {
  Value properties = object({});
  Value::Array required;
  for (const Key& key : section.keys) {
    Value schema = valueSchema(key);
    schema.set("description", key.help);
    properties.set(key.name, std::move(schema));
    if (key.required) required.emplace_back(key.name);
  }
  Value schema = type("object");
  schema.set("properties", std::move(properties));
  if (!required.empty()) schema.set("required", std::move(required));
  schema.set("additionalProperties", false);
  return schema;
}

/// A section that is chosen by one of its keys' value: {"model": "lambert", …}.
Value chosenBy(const std::string& key, const std::string& name, const Section& section) {
  Value schema = sectionSchema(section);
  Value properties = *schema.find("properties");
  properties.set(key, object({{"const", name}}));
  schema.set("properties", std::move(properties));
  return schema;
}

Value materialSchema() {
  Value::Array models;
  for (const MaterialForm& form : materialForms()) models.push_back(chosenBy("model", form.model, form.section));
  return anyOf(std::move(models));
}

Value objectSchema() {
  Value::Array shapes;
  for (const geometry::ObjectType& shape : geometry::objectTypes()) {
    shapes.push_back(chosenBy("shape", shape.name, objectSection(shape)));
  }
  shapes.push_back(chosenBy("shape", "group", groupSection()));
  return anyOf(std::move(shapes));
}

Value openingSchema() {
  Value::Array options{texts({"auto", "point"})};
  for (const OpeningForm& form : openingForms()) {
    options.push_back(object({{"type", "object"},
                              {"properties", object({{form.name, sectionSchema(form.section)}})},
                              {"required", Value::Array{form.name}},
                              {"additionalProperties", false}}));
  }
  return anyOf(std::move(options));
}

Value spectrumSchema() {
  Value schema = sectionSchema(spectrumSection());
  Value properties = *schema.find("properties");
  for (const char* list : {"wavelengths", "values"}) properties.set(list, listOf(type("number")));
  for (const char* colour : {"xyz", "srgb"}) properties.set(colour, tuple(3));
  schema.set("properties", std::move(properties));
  std::string names = "file (.spd, .csv, .spdx) or illuminant:";
  for (const std::string& name : spectrum::illuminantNames()) names += " " + name + ",";
  names.back() = '.';
  return anyOf({object({{"type", "string"}, {"description", names}}), std::move(schema)});
}

}  // namespace

core::Value projectSchema() {
  Value schema = sectionSchema(rootSection());
  Value document =
      object({{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "Goniolux project, version 1"},
              {"description", "Lengths in \"units\", angles in degrees, wavelengths in nm; right-handed, z up."}});
  for (const auto& [key, value] : schema.object()) document.set(key, value);
  document.set("$defs", object({{"vector", tuple(3)},
                                {"spectrum", spectrumSchema()},
                                {"material", materialSchema()},
                                {"object", objectSchema()},
                                {"opening", openingSchema()}}));
  return document;
}

}  // namespace goniolux::project
