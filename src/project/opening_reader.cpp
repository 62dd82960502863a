#include "project/opening_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "core/closest_name.h"
#include "geometry/revolution.h"
#include "project/section_reader.h"

namespace goniolux::project {
namespace {

using Shape = emitter::Opening::Shape;

Shape shapeNamed(const std::string& name) {
  if (name == "rectangle") return Shape::rectangle;
  if (name == "disc") return Shape::disc;
  if (name == "box") return Shape::box;
  if (name == "cylinder") return Shape::cylinder;
  if (name == "sphere") return Shape::sphere;
  if (name == "tube") return Shape::tube;
  if (name == "line") return Shape::line;
  if (name == "revolution") return Shape::revolution;
  return Shape::point;
}

bool readProfile(SectionReader& section, const Section& table, emitter::Opening& opening, Reading& reading) {
  const auto pairs = readPairs(*section.find("profile"), *table.find("profile"), reading);
  if (!pairs) return false;
  for (const core::Vec2& pair : *pairs) opening.profile.push_back(pair * reading.metresPerUnit);
  try {
    (void)geometry::makeRevolution(opening.profile, {0, 0, 0}, {0, 0, 1});
  } catch (const std::invalid_argument& fault) {
    section.refuse("profile", "bad-profile", fault.what());
    return false;
  }
  opening.profile = emitter::convexProfile(opening.profile);
  if (!opening.profile.empty()) return true;
  section.refuse("profile", "bad-profile",
                 "the profile must begin and end on the axis and bulge outward everywhere: no direction may miss the "
                 "luminous surface, and no part of it may hide another");
  return false;
}

std::optional<emitter::Opening> readStated(const core::Value& shape, Reading& reading) {
  if (shape.object().size() != 1) {
    reading.error(shape, "opening-form", "a luminaire's shape is one of { \"rectangle\": {…} }, { \"disc\": {…} } …");
    return std::nullopt;
  }
  const auto& [name, value] = shape.object().front();
  std::vector<std::string> known;
  for (const OpeningForm& form : openingForms()) known.push_back(form.name);
  const auto form = std::find_if(openingForms().begin(), openingForms().end(),
                                 [&](const OpeningForm& each) { return each.name == name; });
  if (form == openingForms().end()) {
    reading.diagnostics.error(value.keyPosition(), "unknown-shape",
                              fmt::format("a luminaire cannot be a \"{}\"{}", name, core::suggestion(name, known)));
    return std::nullopt;
  }
  SectionReader section(value, form->section, reading);
  if (section.failed()) return std::nullopt;
  emitter::Opening opening;
  opening.shape = shapeNamed(name);
  const auto length = [&](const char* key) { return form->section.find(key) ? section.length(key).value_or(0) : 0; };
  opening.length = length("length");
  opening.width = length("width");
  opening.height = length("height");
  opening.diameter = length("diameter");
  if (opening.shape == Shape::revolution && !readProfile(section, form->section, opening, reading)) return std::nullopt;
  if (form->section.find("axis")) opening.axis = section.direction("axis").value_or(core::Vec3(1, 0, 0));
  return section.failed() ? std::nullopt : std::optional(opening);
}

emitter::Opening automatic(const core::Value* shape, const photometry::PhotometricFile* file,
                           const photometry::LuminaireFrame& frame, Reading& reading) {
  if (!file) return {};
  emitter::Opening opening = openingOf(file->opening);
  if (opening.shape == Shape::line) opening.axis = emitter::axesOf(opening, frame).z;
  if (file->opening.shape == photometry::StatedOpening::Shape::other) {
    reading.diagnostics.warning(
        shape ? shape->position() : core::SourcePosition{file->file, 0, 0}, "opening-approximated",
        fmt::format("{} states an opening that has no model here ({}); it is taken as {}; give \"shape\" for another",
                    file->file, file->opening.note, "a point"));
  }
  return opening;
}

}  // namespace

emitter::Opening openingOf(const photometry::StatedOpening& stated) {
  using Stated = photometry::StatedOpening::Shape;
  using Axis = photometry::StatedOpening::Axis;
  using Along = emitter::Opening::Along;
  const double c0 = stated.lengthAlongC90 ? stated.width : stated.length,
               c90 = stated.lengthAlongC90 ? stated.length : stated.width, aim = stated.height;
  emitter::Opening opening;
  if (stated.axis != Axis::aim)
    opening.along = (stated.axis == Axis::lengthwise) != stated.lengthAlongC90 ? Along::c0 : Along::c90;
  if (stated.shape == Stated::line) opening.along = aim > 0 ? Along::aim : c0 > 0 ? Along::c0 : Along::c90;
  // Extents along the opening's own axes (x, y, z).
  const core::Vec3 extent = opening.along == Along::c0    ? core::Vec3(c90, aim, c0)
                            : opening.along == Along::c90 ? core::Vec3(aim, c0, c90)
                                                          : core::Vec3(c0, c90, aim);
  opening.length = extent.x;
  opening.width = extent.y;
  opening.height = extent.z;
  switch (stated.shape) {
    case Stated::point:
    case Stated::other:
      return {};
    case Stated::line:
      opening.shape = Shape::line;
      opening.length = extent.z;
      break;
    case Stated::rectangle:
      opening.shape = Shape::rectangle;
      break;
    case Stated::disc:
      opening.shape = Shape::disc;
      break;
    case Stated::box:
      opening.shape = Shape::box;
      break;
    case Stated::cylinder:
      opening.shape = Shape::cylinder;
      break;
    case Stated::sphere:
      opening.shape = Shape::sphere;
      break;
  }
  const bool curved =
      opening.shape == Shape::disc || opening.shape == Shape::cylinder || opening.shape == Shape::sphere;
  if (curved && emitter::isRound(opening)) opening.diameter = extent.x;
  return opening;
}

std::optional<emitter::Opening> readOpening(const core::Value* shape, const photometry::PhotometricFile* file,
                                            const photometry::LuminaireFrame& frame, Reading& reading) {
  if (!shape || (shape->isString() && shape->string() == "auto")) return automatic(shape, file, frame, reading);
  if (shape->isString() && shape->string() == "point") return emitter::Opening{};
  if (shape->isObject()) return readStated(*shape, reading);
  reading.error(*shape, "opening-form",
                "a luminaire's shape is \"auto\", \"point\", or an object such as { \"rectangle\": { \"length\": 0.6, "
                "\"width\": 0.6 } }");
  return std::nullopt;
}

bool hasSurface(const emitter::Opening& opening) {
  return opening.shape != Shape::point && opening.shape != Shape::line;
}

}  // namespace goniolux::project
