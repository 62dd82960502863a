#include "project/object_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/closest_name.h"
#include "geometry/smooth_normals.h"
#include "project/arguments_reader.h"
#include "project/section_reader.h"
#include "project/transform_reader.h"

namespace goniolux::project {
namespace {

std::vector<std::string> shapeNames() {
  std::vector<std::string> names;
  for (const geometry::ObjectType& type : geometry::objectTypes()) names.push_back(type.name);
  names.emplace_back("group");
  return names;
}

const geometry::ObjectType* typeOf(const core::Value& value, Reading& reading) {
  const core::Value* shape = value.find("shape");
  if (!shape) {
    reading.error(value, "missing-key", fmt::format("an object needs \"shape\": {}", fmt::join(shapeNames(), ", ")));
    return nullptr;
  }
  const auto name = readText(*shape, {.name = "shape", .form = Form::text}, reading);
  if (!name) return nullptr;
  if (const geometry::ObjectType* type = geometry::findObjectType(*name)) return type;
  reading.error(*shape, "unknown-shape",
                fmt::format("there is no shape \"{}\"{}", *name, core::suggestion(*name, shapeNames())));
  return nullptr;
}

class MaterialNames {
 public:
  MaterialNames(const std::vector<material::Material>& materials, Reading& reading)
      : materials_(materials), reading_(reading) {}

  /// Index of the material that a value names.
  std::optional<std::uint32_t> find(const core::Value& value) {
    const auto name = readText(value, {.name = "material", .form = Form::text}, reading_);
    if (!name) return std::nullopt;
    for (std::uint32_t i = 0; i < materials_.size(); ++i) {
      if (materials_[i].name == *name) return i;
    }
    std::vector<std::string> known;
    for (const material::Material& material : materials_) known.push_back(material.name);
    reading_.error(value, "unknown-material",
                   fmt::format("the material \"{}\" is not defined{}", *name,
                               known.empty() ? "; add it to \"materials\"" : core::suggestion(*name, known)));
    return std::nullopt;
  }

 private:
  const std::vector<material::Material>& materials_;
  Reading& reading_;
};

/// Material of each part: its own name in "materials" wins over a group's ("walls"), that over "*" and "material".
void readPartMaterials(SectionReader& section, const geometry::ObjectType& type, MaterialNames names,
                       scene::Object& object, Reading& reading) {
  const std::vector<std::string>& parts = object.shape.partNames;
  auto groups = type.partGroups;
  groups.insert(object.shape.partGroups.begin(), object.shape.partGroups.end());  // a mesh file's own
  std::optional<std::uint32_t> all;
  bool failed = false;
  const auto look = [&](const core::Value& value) {
    const auto index = names.find(value);
    failed |= !index;
    return index;
  };
  if (const core::Value* material = section.find("material")) all = look(*material);
  std::vector<std::optional<std::uint32_t>> own(parts.size()), group(parts.size());
  if (const core::Value* materials = section.find("materials")) {
    if (!materials->isObject()) {
      section.refuse("materials", "wrong-type", "\"materials\" must be an object: { \"part\": \"material\", … }");
      return;
    }
    for (const auto& [part, value] : materials->object()) {
      const auto position = std::find(parts.begin(), parts.end(), part);
      const auto members = groups.find(part);
      if (part == "*") {
        all = look(value);
      } else if (position != parts.end()) {
        own[static_cast<std::size_t>(position - parts.begin())] = look(value);
      } else if (members != groups.end()) {
        const auto index = look(value);
        for (std::size_t i = 0; i < parts.size(); ++i) {
          const auto& list = members->second;
          if (std::find(list.begin(), list.end(), parts[i]) != list.end()) group[i] = index;
        }
      } else {
        std::vector<std::string> known = parts;
        for (const auto& [name, list] : groups) known.push_back(name);
        known.emplace_back("*");
        reading.diagnostics.error(
            value.keyPosition(), "unknown-part",
            fmt::format("the {} has no part \"{}\"{}", type.name, part, core::suggestion(part, known)));
        failed = true;
      }
    }
  }
  std::vector<std::string> bare;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto index = own[i] ? own[i] : group[i] ? group[i] : all;
    if (!index) bare.push_back(parts[i]);
    object.materials.push_back(index.value_or(0));
  }
  if (!bare.empty() && !failed) {
    reading.error(section.value(), "missing-material",
                  fmt::format("no material for {} of \"{}\"; give \"material\" or \"materials\"", fmt::join(bare, ", "),
                              object.name));
  }
}

std::optional<scene::Object> readObject(const core::Value& value, std::size_t number,
                                        const std::vector<material::Material>& materials, Reading& reading) {
  if (!value.isObject()) {
    reading.error(value, "wrong-type", "an object of the scene is expected here: { \"shape\": \"box\", … }");
    return std::nullopt;
  }
  const geometry::ObjectType* type = typeOf(value, reading);
  if (!type) return std::nullopt;
  const Section description = objectSection(*type);
  SectionReader section(value, description, reading);
  scene::Object object;
  object.position = value.position();
  object.name = section.text("name").value_or(fmt::format("{} {}", type->name, number + 1));
  object.facesInward = section.choice("facing").value_or("outward") == "inward";
  if (const core::Value* steps = section.find("transform")) object.transform = readTransform(*steps, reading);
  const auto arguments = readArguments(section, type->parameters, reading);
  if (!arguments) return std::nullopt;
  try {
    object.shape = type->make(*arguments);
  } catch (const std::invalid_argument& wrong) {
    reading.error(value, "bad-shape", fmt::format("\"{}\": {}", object.name, wrong.what()));
    return std::nullopt;
  } catch (const core::InputError& error) {  // the shape's own file
    reading.adopt(error);
    return std::nullopt;
  }
  if (const auto crease = section.number("smooth"); crease && !object.shape.mesh.triangles.empty())
    geometry::addSmoothNormals(object.shape.mesh, *crease * core::degree);
  for (const std::string& remark : object.shape.remarks) reading.warning(value, "shape", remark);
  if (object.facesInward && !object.shape.closed) {
    section.refuse("facing", "not-closed",
                   fmt::format("\"{}\" is not closed: it has no inside to face; leave \"facing\" out", object.name));
  }
  readPartMaterials(section, *type, MaterialNames(materials, reading), object, reading);
  return object;
}

/// Where the elements of an array stand, as further transforms in the world; one place without an array. Empty after an
/// error. `names` gets "[i,j]" for each.
std::vector<core::Mat4> placesOfArray(const core::Value& value, std::vector<std::string>& names, Reading& reading) {
  constexpr double mostElements = 1e6;
  const core::Value* array = value.find("array");
  if (!array) {
    names = {""};
    return {core::Mat4(1.0)};
  }
  SectionReader section(*array, arraySection(), reading);
  const auto counts = section.isObject() ? section.counts("counts") : std::nullopt;
  if (!counts) return {};
  const auto u = section.point("u"), v = section.point("v");
  const auto [along, across] = *counts;
  if ((along > 1 && !u) || (across > 1 && !v)) {
    section.refuse("counts", "missing-step",
                   "several in a row need the step from one to the next: \"u\", and \"v\" for rows");
    return {};
  }
  if (double(along) * across > mostElements) {
    section.refuse("counts", "too-many", "an array has at most a million elements");
    return {};
  }
  std::vector<core::Mat4> places;
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < along; ++i) {
      core::Mat4 place(1.0);
      place[3] = {double(i) * u.value_or(core::Vec3(0)) + double(j) * v.value_or(core::Vec3(0)), 1};
      places.push_back(place);
      names.push_back(fmt::format("[{},{}]", i, j));
    }
  }
  return places;
}

/// Objects placed together, or every element of their array: of small meshes as objects of their own; large ones stay
/// one object with copies, so that their triangles are held once however deep groups are nested.
void addPlaced(const core::Value& value, std::vector<scene::Object> together, const std::string& name,
               const core::Mat4& transform, std::vector<scene::Object>& objects, Reading& reading) {
  constexpr std::size_t mostSeparate = 100'000;  // triangles
  constexpr std::size_t mostObjects = 2'000'000;
  std::vector<std::string> suffixes;
  std::vector<core::Mat4> places = placesOfArray(value, suffixes, reading);
  const bool isArray = value.find("array") != nullptr;
  for (core::Mat4& place : places) place = place * transform;
  if (objects.size() + places.size() * together.size() > mostObjects) {
    reading.error(value, "too-many", "the scene has more than two million objects; make the arrays smaller");
    return;
  }
  std::vector<scene::Object> apart, shared;
  for (scene::Object& object : together) {
    const bool separate =
        places.size() == 1 || object.facesInward ||
        object.shape.mesh.triangles.size() * places.size() * (object.copies.size() + 1) <= mostSeparate;
    (separate ? apart : shared).push_back(std::move(object));
  }
  for (std::size_t p = 0; p < places.size(); ++p) {
    for (const scene::Object& object : apart) {
      scene::Object& placed = objects.emplace_back(object);
      placed.transform = places[p] * object.transform;
      for (core::Mat4& copy : placed.copies) copy = places[p] * copy;
      if (isArray) placed.name = object.name.substr(0, name.size()) + suffixes[p] + object.name.substr(name.size());
    }
  }
  for (scene::Object& object : shared) {
    const std::vector<core::Mat4> own = scene::placesOf(object);
    object.copies.clear();
    for (const core::Mat4& place : places)
      for (const core::Mat4& at : own) object.copies.push_back(place * at);
    object.transform = object.copies.front();
    object.copies.erase(object.copies.begin());
    objects.push_back(std::move(object));
  }
}

class ObjectsReader {
 public:
  ObjectsReader(const std::vector<material::Material>& materials, Reading& reading)
      : materials_(materials), reading_(reading) {}

  std::vector<scene::Object> read(const core::Value& section, int depth) {
    std::vector<scene::Object> objects;
    if (!section.isArray() || section.array().empty()) {
      reading_.error(section, "wrong-type", "\"objects\" must be a list with at least one object");
      return objects;
    }
    for (std::size_t i = 0; i < section.array().size(); ++i) {
      const core::Value& value = section.array()[i];
      const core::Value* shape = value.isObject() ? value.find("shape") : nullptr;
      if (shape != nullptr && shape->isString() && shape->string() == "group") {
        readGroup(value, i, depth, objects);
      } else if (auto object = readObject(value, i, materials_, reading_)) {
        const std::string name = object->name;
        std::vector<scene::Object> alone;
        alone.push_back(std::move(*object));
        const core::Mat4 own = std::exchange(alone.front().transform, core::Mat4(1.0));
        addPlaced(value, std::move(alone), name, own, objects, reading_);
      }
    }
    return objects;
  }

 private:
  void readGroup(const core::Value& value, std::size_t number, int depth, std::vector<scene::Object>& objects) {
    constexpr int deepest = 32;
    SectionReader section(value, groupSection(), reading_);
    const core::Value* members = section.find("objects");
    if (!section.isObject() || members == nullptr) return;
    if (depth >= deepest) {
      section.refuse("objects", "too-deep", fmt::format("groups are nested at most {} deep", deepest));
      return;
    }
    const std::string name = section.text("name").value_or(fmt::format("group {}", number + 1));
    std::vector<scene::Object> together = read(*members, depth + 1);
    for (scene::Object& object : together) object.name = name + "/" + object.name;
    const core::Value* steps = section.find("transform");
    addPlaced(value, std::move(together), name, steps ? readTransform(*steps, reading_) : core::Mat4(1.0), objects,
              reading_);
  }

  const std::vector<material::Material>& materials_;
  Reading& reading_;
};

}  // namespace

std::vector<scene::Object> readObjects(const core::Value& section, const std::vector<material::Material>& materials,
                                       Reading& reading) {
  return ObjectsReader(materials, reading).read(section, 0);
}

}  // namespace goniolux::project
