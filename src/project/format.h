// The project format as data: every section of a project file and the keys it may hold. The reader accepts nothing that
// does not stand here, and `goniolux schema` is made from the same tables, so that the two cannot part.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameter.h"
#include "geometry/objects.h"

namespace goniolux::project {

/// What the value of a key looks like.
enum class Form {
  number,
  numberOrNull,
  integer,
  boolean,
  text,
  choice,         ///< one of Key::choices
  file,           ///< path of a file
  length,         ///< number in the project's units
  point,          ///< three lengths
  direction,      ///< three numbers, not all 0
  points,         ///< list of points
  directions,     ///< list of directions
  profile,        ///< list of pairs of lengths
  faces,          ///< list of lists of vertex numbers
  loops,          ///< list of lists of points
  counts,         ///< two whole numbers, 1 or more
  percentage,     ///< "2 %", or 0.02
  reflectance,    ///< SPECTRUM between 0 and 1
  source,         ///< SPECTRUM of a light source: relative, not negative, with some luminous power
  quantity,       ///< SPECTRUM that is not negative: attenuation, radiance
  index,          ///< refractive index: SPECTRUM above 0, {"cauchy": […]} or {"sellmeier": {…}}
  curve,          ///< list of [angle, value] pairs
  numbers,        ///< list of numbers
  section,        ///< an object: Key::section
  sections,       ///< list of such objects
  numberMap,      ///< names of the user's choice with a number each
  materials,      ///< names of the user's choice with a material each
  objects,        ///< list of objects, by shape
  partMaterials,  ///< part name -> material name
  transform,      ///< list of {"translate"}, {"rotate"}, {"scale"}, {"shear"}
  scale,          ///< one factor or three
  photometry,     ///< file, "diffuse", {"cosine_power": n} …
  opening,        ///< "auto", "point", {"rectangle": {…}} …
  fieldOfView,    ///< vertical degrees, or {"horizontal": degrees}
  spectral,       ///< "auto", "uniform:9" or {"scheme", "samples"}
};

struct Section;

struct Key {
  std::string name;
  Form form = Form::number;
  std::string help = {};
  bool required = false;
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool minimumIsAllowed = true;           ///< false: the value must be above the minimum
  std::vector<std::string> choices = {};  ///< Form::choice
  const Section* section = nullptr;       ///< Form::section, Form::sections
  std::string unit = {};                  ///< of a number that has one whatever the project's units: "lm"
};

struct Section {
  std::string title;  ///< as messages name it: "a luminaire"
  std::vector<Key> keys;

  [[nodiscard]] const Key* find(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> names() const;
};

const Section& rootSection();
const Section& luminaireSection();
const Section& arraySection();
const Section& gridSection();
const Section& observerSection();
const Section& viewSection();
const Section& requirementSection();
const Section& limitSection();
const Section& lightingSceneSection();
const Section& settingsSection();
const Section& accuracySection();
const Section& treeSection();
const Section& pixelSection();
const Section& spectralSection();
const Section& horizontalFieldSection();
const Section& transformStepSection();
const Section& rotationSection();
const Section& shearSection();
const Section& textureSection();
const Section& bumpSection();
/// SPECTRUM as an object: which of its keys stand together is checked by the reader.
const Section& spectrumSection();
const Section& photometrySection();
const Section& dispersionSection();
const Section& sellmeierSection();
const Section& goniometricSection();

/// A luminous opening that a luminaire's "shape" may state: {"rectangle": {"length": …, "width": …}}.
struct OpeningForm {
  std::string name;
  Section section;
};
const std::vector<OpeningForm>& openingForms();

/// A reflection model with its parameters as a material's keys.
struct MaterialForm {
  std::string model;
  Section section;
};
const std::vector<MaterialForm>& materialForms();

/// An object type of the geometry registry with its parameters as an object's keys, besides those that every object
/// has.
Section objectSection(const geometry::ObjectType& type);

/// Several objects that are placed together: "shape": "group".
const Section& groupSection();

/// Photometry by name instead of a file.
const std::vector<std::string>& builtInPhotometry();

}  // namespace goniolux::project
