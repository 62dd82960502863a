#include "pipeline/answerable.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/queries.h"
#include "pipeline/geometry_findings.h"
#include "scene/housing.h"

namespace goniolux::pipeline {
namespace {

using scene::Object;

bool areAlike(const material::Material& a, const material::Material& b) {
  const bool emits = a.emission.has_value() || b.emission.has_value();
  return !emits && a.model == b.model && a.spectra == b.spectra && a.numbers == b.numbers;
}

/// True when light finds the same finish whichever of the two it meets.
bool haveOneFinish(const project::Project& project, const Object& a, const Object& b) {
  const auto& materials = project.environment.materials;
  const material::Material& first = materials[a.materials.front()];
  const auto isAlike = [&](std::uint32_t index) { return areAlike(first, materials[index]); };
  return std::all_of(a.materials.begin(), a.materials.end(), isAlike) &&
         std::all_of(b.materials.begin(), b.materials.end(), isAlike);
}

/// Bodies of glass or water may overlap: the later one displaces the earlier, also where their faces lie in one
/// another.
bool areGlass(const project::Project& project, const Object& object) {
  const auto& materials = project.environment.materials;
  return object.shape.closed && std::all_of(object.materials.begin(), object.materials.end(), [&](std::uint32_t index) {
           return materials[index].model == "dielectric" && !materials[index].numbers.contains("thickness_m");
         });
}

void findContradictions(const project::Project& project, core::Diagnostics& found) {
  const auto& objects = project.environment.objects;
  core::Diagnostics notSearched;  // `check` names what is too large to be searched
  for (const geometry::Coincidence& c : coincidencesOf(project, notSearched)) {
    const Object &first = objects[c.first], &second = objects[c.second];
    if (haveOneFinish(project, first, second) || (areGlass(project, first) && areGlass(project, second))) continue;
    found.error(second.position, "coincident",
                fmt::format("\"{}\" lies in the same plane as \"{}\" (line {}) with another finish, both seen, at {}: "
                            "which one light meets is chance, so there is no answer; move it by a millimetre, or let "
                            "`goniolux check --fix` part them",
                            second.name, first.name, first.position.line, placeText(c.place)));
  }
}

void findOpenGlass(const project::Project& project, core::Diagnostics& found) {
  for (const Object& object : project.environment.objects) {
    if (const material::Material* glass = scene::openGlassOf(project.environment, object))
      found.error(
          object.position, "open-glass",
          fmt::format("\"{}\" is of \"{}\", but its surface is not closed: glass without an inside has no answer; "
                      "close it, or give the material a \"thickness_m\" for a thin pane",
                      object.name, glass->name));
  }
}

}  // namespace

void refuseWhatHasNoAnswer(const project::Project& project) {
  core::Diagnostics found;
  findContradictions(project, found);
  findOpenGlass(project, found);
  if (found.hasErrors()) throw core::InputError(found);
}

std::vector<std::string> hiddenLuminaires(const project::Project& project) {
  std::vector<std::string> sentences;
  for (const scene::Enclosure& enclosure : scene::enclosuresOf(project.environment))
    if (!enclosure.isHousing)
      sentences.push_back(fmt::format("the light of \"{}\", which is inside \"{}\": it does not come out",
                                      project.environment.luminaires[enclosure.luminaire].name,
                                      project.environment.objects[enclosure.object].name));
  return sentences;
}

}  // namespace goniolux::pipeline
