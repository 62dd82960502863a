// The sections of the format that describe the environment: materials, objects, luminaires, spectra.
#include <algorithm>

#include "project/format.h"
#include "reflection/bsdf.h"
#include "reflection/shading.h"

namespace goniolux::project {
namespace {

Key openingLength(const char* name, const char* help) {
  return {.name = name, .form = Form::length, .help = help, .required = true, .minimum = 0, .minimumIsAllowed = false};
}

Key openingAxis() {
  return {.name = "axis", .form = Form::direction, .help = "of the tube or line; default [1, 0, 0]"};
}

/// The keys of a material: its model's own, and emission, which any surface may have.
Section materialSection(std::vector<Key> parameters) {
  std::vector<Key> keys{{.name = "model", .form = Form::choice, .help = "reflection model", .required = true}};
  keys.insert(keys.end(), parameters.begin(), parameters.end());
  keys.push_back({.name = "exitance_lm_m2",
                  .form = Form::number,
                  .help = "diffuse light that the surface emits",
                  .minimum = 0,
                  .unit = "lm/m²"});
  keys.push_back({.name = "spectrum", .form = Form::source, .help = "of the emission", .minimum = 0});
  keys.push_back({.name = "texture",
                  .form = Form::section,
                  .help = "another finish, or a picture's colours, from place to place",
                  .section = &textureSection()});
  keys.push_back(
      {.name = "bump", .form = Form::section, .help = "a relief, seen in pictures", .section = &bumpSection()});
  return {"a material", std::move(keys)};
}

Form formOf(core::ParameterKind kind) {
  switch (kind) {
    case core::ParameterKind::number:
      return Form::number;
    case core::ParameterKind::length:
      return Form::length;
    case core::ParameterKind::text:
      return Form::text;
    case core::ParameterKind::file:
      return Form::file;
    case core::ParameterKind::spectrum:
      return Form::quantity;
    case core::ParameterKind::refractiveIndex:
      return Form::index;
    case core::ParameterKind::boolean:
      return Form::boolean;
    case core::ParameterKind::direction:
      return Form::direction;
    case core::ParameterKind::point:
      return Form::point;
    case core::ParameterKind::points2:
      return Form::profile;
    case core::ParameterKind::points3:
      return Form::points;
    case core::ParameterKind::faces:
      return Form::faces;
    case core::ParameterKind::loops3:
      return Form::loops;
  }
  return Form::number;
}

Key keyOf(const core::Parameter& parameter) {
  const bool isFraction = parameter.kind == core::ParameterKind::spectrum && parameter.maximum <= 1;
  return {.name = parameter.key,
          .form = isFraction ? Form::reflectance : formOf(parameter.kind),
          .help = parameter.help,
          .required = parameter.required,
          .minimum = parameter.minimum,
          .maximum = parameter.maximum,
          .minimumIsAllowed = parameter.minimumIsAllowed,
          .unit = parameter.unit};
}

}  // namespace

const std::vector<MaterialForm>& materialForms() {
  static const std::vector<MaterialForm> forms = [] {
    std::vector<MaterialForm> list;
    for (const reflection::ReflectionModel& model : reflection::reflectionModels()) {
      std::vector<Key> keys;
      for (const core::Parameter& parameter : model.parameters) keys.push_back(keyOf(parameter));
      list.push_back({model.name, materialSection(std::move(keys))});
    }
    for (const reflection::ShadingModel& model : reflection::shadingModels()) {
      std::vector<Key> keys;
      for (const core::Parameter& parameter : model.parameters) keys.push_back(keyOf(parameter));
      list.push_back({model.name, materialSection(std::move(keys))});
    }
    return list;
  }();
  return forms;
}

const Section& dispersionSection() {
  static const Section section{
      "a refractive index",
      {{.name = "cauchy", .form = Form::numbers, .help = "[A, B, C] of A + B/w^2 + C/w^4, w in micrometres"},
       {.name = "sellmeier",
        .form = Form::section,
        .help = "n^2 = 1 + sum of b w^2/(w^2 - c), w in micrometres",
        .section = &sellmeierSection()}}};
  return section;
}

const Section& sellmeierSection() {
  static const Section section{"Sellmeier's formula",
                               {{.name = "b", .form = Form::numbers, .help = "coefficients", .required = true},
                                {.name = "c", .form = Form::numbers, .help = "square micrometres", .required = true}}};
  return section;
}

Section objectSection(const geometry::ObjectType& type) {
  Section section{
      "a " + type.name,
      {{.name = "name", .form = Form::text, .help = "for messages and plots"},
       {.name = "shape", .form = Form::choice, .help = type.title, .required = true, .choices = {type.name}},
       {.name = "material",
        .form = Form::text,
        .help = "name of the material of all parts that \"materials\" leaves out"},
       {.name = "materials", .form = Form::partMaterials, .help = "material by part; \"*\" = all others"},
       {.name = "transform", .form = Form::transform, .help = "steps, applied one after the other"},
       {.name = "array", .form = Form::section, .help = "several of it in rows", .section = &arraySection()},
       {.name = "smooth",
        .form = Form::number,
        .help = "edges of its triangles that bend by less look round in pictures; numbers stay those of the flat faces",
        .minimum = 0,
        .maximum = 180,
        .unit = "°"},
       {.name = "facing", .form = Form::choice, .help = "inward: a room", .choices = {"outward", "inward"}}}};
  for (const core::Parameter& parameter : type.parameters) {
    section.keys.push_back({.name = parameter.key,
                            .form = formOf(parameter.kind),
                            .help = parameter.help,
                            .required = parameter.required,
                            .minimum = parameter.minimum,
                            .maximum = parameter.maximum,
                            .minimumIsAllowed = parameter.minimumIsAllowed,
                            .unit = parameter.unit});
  }
  return section;
}

const Section& groupSection() {
  static const Section section{
      "a group",
      {{.name = "name", .form = Form::text, .help = "for messages and plots; its objects are NAME/OBJECT"},
       {.name = "shape",
        .form = Form::choice,
        .help = "Objects placed together",
        .required = true,
        .choices = {"group"}},
       {.name = "objects", .form = Form::objects, .help = "what belongs to it; groups, too", .required = true},
       {.name = "transform", .form = Form::transform, .help = "of all of them, after their own"},
       {.name = "array", .form = Form::section, .help = "several of it in rows", .section = &arraySection()}}};
  return section;
}

const Section& transformStepSection() {
  static const Section section{
      "a transform step",
      {{.name = "translate", .form = Form::point, .help = "move by"},
       {.name = "rotate", .form = Form::section, .help = "turn about an axis", .section = &rotationSection()},
       {.name = "scale",
        .form = Form::scale,
        .help = "one factor, or one along each axis",
        .minimum = 0,
        .minimumIsAllowed = false},
       {.name = "shear",
        .form = Form::section,
        .help = "move points along one axis by another",
        .section = &shearSection()}}};
  return section;
}

const Section& shearSection() {
  static const Section section{"a shear",
                               {{.name = "xy", .form = Form::number, .help = "x grows by so many y"},
                                {.name = "xz", .form = Form::number, .help = "x grows by so many z"},
                                {.name = "yx", .form = Form::number, .help = "y grows by so many x"},
                                {.name = "yz", .form = Form::number, .help = "y grows by so many z"},
                                {.name = "zx", .form = Form::number, .help = "z grows by so many x"},
                                {.name = "zy", .form = Form::number, .help = "z grows by so many y"}}};
  return section;
}

const Section& rotationSection() {
  static const Section section{
      "a rotation",
      {{.name = "axis", .form = Form::direction, .help = "right-handed about it", .required = true},
       {.name = "degrees", .form = Form::number, .help = "angle", .required = true, .unit = "°"},
       {.name = "center", .form = Form::point, .help = "a point of the axis; default the origin"}}};
  return section;
}

const Section& luminaireSection() {
  static const Section section{
      "a luminaire",
      {{.name = "name", .form = Form::text, .help = "unique"},
       {.name = "photometry", .form = Form::photometry, .help = "file, or how light leaves", .required = true},
       {.name = "position", .form = Form::point, .help = "centre of the opening", .required = true},
       {.name = "aim", .form = Form::direction, .help = "direction of gamma = 0; default [0, 0, -1]"},
       {.name = "c0", .form = Form::direction, .help = "direction of the plane C0; default [1, 0, 0]"},
       {.name = "turn", .form = Form::number, .help = "degrees about aim, right-handed", .unit = "°"},
       {.name = "rotation",
        .form = Form::number,
        .help = "instead of aim and c0: degrees about the vertical, anticlockwise seen from above",
        .unit = "°"},
       {.name = "tilt",
        .form = Form::number,
        .help = "with rotation: degrees from straight down towards where C0 then lies",
        .unit = "°"},
       {.name = "array", .form = Form::section, .help = "several of it in rows", .section = &arraySection()},
       {.name = "spectrum", .form = Form::source, .help = "relative; default CIE E (equal energy)", .minimum = 0},
       {.name = "flux",
        .form = Form::number,
        .help = "lm that leave one luminaire",
        .minimum = 0,
        .minimumIsAllowed = false,
        .unit = "lm"},
       {.name = "lamp_flux",
        .form = Form::number,
        .help = "lm of the lamps, instead of the file's",
        .minimum = 0,
        .minimumIsAllowed = false,
        .unit = "lm"},
       {.name = "maintenance",
        .form = Form::number,
        .help = "factor; default 1",
        .minimum = 0,
        .maximum = 1,
        .minimumIsAllowed = false},
       {.name = "dimming", .form = Form::number, .help = "factor; default 1", .minimum = 0},
       {.name = "group", .form = Form::text, .help = "that scenes dim together; default the luminaire's name"},
       {.name = "shape", .form = Form::opening, .help = "of the luminous opening; default auto"},
       {.name = "reflectance", .form = Form::number, .help = "of the opening; default 0", .minimum = 0, .maximum = 1}}};
  return section;
}

const Section& arraySection() {
  static const Section section{
      "an array",
      {{.name = "counts", .form = Form::counts, .help = "how many along u and v", .required = true},
       {.name = "u", .form = Form::point, .help = "step from one to the next"},
       {.name = "v", .form = Form::point, .help = "step of the second row"}}};
  return section;
}

const std::vector<OpeningForm>& openingForms() {
  static const std::vector<OpeningForm> forms{
      {"rectangle", {"a rectangle", {openingLength("length", "along c0"), openingLength("width", "along C90")}}},
      {"disc", {"a disc", {openingLength("diameter", "of the disc")}}},
      {"box",
       {"a box",
        {openingLength("length", "along c0"), openingLength("width", "along C90"),
         openingLength("height", "along aim")}}},
      {"cylinder",
       {"a cylinder", {openingLength("diameter", "of the cylinder"), openingLength("height", "along aim")}}},
      {"sphere", {"a sphere", {openingLength("diameter", "of the sphere")}}},
      {"tube",
       {"a tube", {openingLength("length", "along axis"), openingLength("diameter", "of the tube"), openingAxis()}}},
      {"line", {"a line", {openingLength("length", "along axis"), openingAxis()}}},
      {"revolution",
       {"a revolution",
        {{.name = "profile",
          .form = Form::profile,
          .help = "[r, z] points, turned about aim, z along it from position; convex, emits outside",
          .required = true}}}},
  };
  return forms;
}

const std::vector<std::string>& builtInPhotometry() {
  static const std::vector<std::string> names{"isotropic", "cosine", "diffuse"};
  return names;
}

const Section& photometrySection() {
  static const Section section{
      "photometry",
      {{.name = "cosine_power", .form = Form::number, .help = "I = I0 cos^n(gamma)", .minimum = 0, .maximum = 1e6},
       {.name = "goniometric",
        .form = Form::section,
        .help = "one or two diagrams",
        .section = &goniometricSection()}}};
  return section;
}

const Section& goniometricSection() {
  static const Section section{
      "goniometric",
      {{.name = "c0", .form = Form::curve, .help = "[gamma, cd] in the plane C0-C180", .required = true},
       {.name = "c90", .form = Form::curve, .help = "[gamma, cd] in the plane C90-C270"}}};
  return section;
}

const Section& spectrumSection() {
  static const Section section{
      "a spectrum",
      {{.name = "wavelengths", .form = Form::number, .help = "nm, ascending"},
       {.name = "values", .form = Form::number, .help = "one for each of wavelengths"},
       {.name = "blackbody", .form = Form::number, .help = "kelvin", .minimum = 500, .maximum = 1e6},
       {.name = "lines", .form = Form::curve, .help = "[nm, power] each"},
       {.name = "continuum", .form = Form::quantity, .help = "below the lines"},
       {.name = "xyz", .form = Form::number, .help = "smoothest reflectance with this colour under D65"},
       {.name = "srgb", .form = Form::number, .help = "smoothest reflectance with this colour under D65"}}};
  return section;
}

}  // namespace goniolux::project
