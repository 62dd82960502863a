#include "pipeline/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "geometry/mesh_checks.h"
#include "geometry/obj_file.h"
#include "geometry/queries.h"
#include "pipeline/geometry_findings.h"
#include "project/project_text.h"
#include "project/results.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using core::Value;
using core::Vec3;
using scene::Object;

constexpr double widestCrack = 1e-5;  // of the mesh's extent

// Triangles over the same three corners: the second can only hide the first.
void removeDoubles(geometry::Mesh& mesh) {
  std::map<std::array<std::uint32_t, 3>, bool> seen;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    auto corners = mesh.triangles[i];
    std::sort(corners.begin(), corners.end());
    if (!seen.try_emplace(corners, true).second) continue;
    mesh.triangles[kept] = mesh.triangles[i];
    mesh.parts[kept++] = mesh.parts[i];
  }
  mesh.triangles.resize(kept);
  mesh.parts.resize(kept);
}

class Repair {
 public:
  Repair(const project::Project& project, std::string file)
      : project_(project), file_(std::move(file)), text_(core::readFile(project.file), project.file) {}

  std::vector<std::string> run() {
    liftCoincident();
    for (const Object& object : project_.environment.objects) mend(object);
    if (!done_.empty()) {
      for (const auto& [path, bytes] : models_) {
        std::error_code failure;
        fs::create_directories(fs::path(path).parent_path(), failure);  // writeFile says what is wrong
        core::writeFile(path, bytes);
      }
      core::writeFile(file_, text_.text());
    }
    return done_;
  }

 private:
  // The object's entry in the text as it is now; null for an element of an array, which shares its entry.
  const Value* entryOf(const Object& object) {
    const auto& objects = project_.environment.objects;
    std::size_t index = 0, sharing = 0, found = 0;
    int line = -1, column = -1;
    for (const Object& other : objects) {  // entries in their order; elements of an array follow each other
      const bool isNew = other.position.line != line || other.position.column != column;
      if (isNew) line = other.position.line, column = other.position.column, ++index;
      if (other.position.line == object.position.line && other.position.column == object.position.column)
        ++sharing, found = index;
    }
    const Value& list = *text_.root().find("objects");
    return sharing == 1 && found <= list.array().size() ? &list.array()[found - 1] : nullptr;
  }

  void liftCoincident() {
    core::Diagnostics ignored;
    geometry::Bounds whole;
    for (const Object& object : project_.environment.objects)
      whole.add(geometry::bounds(object.shape, object.transform));
    const double lift = glm::length(whole.extent()) / 5000;
    std::vector<std::uint32_t> moved;
    for (const geometry::Coincidence& c : coincidencesOf(project_, ignored)) {
      // An open surface off a closed one; of two open ones, the later off the earlier.
      const auto& objects = project_.environment.objects;
      const bool secondIsOpen = !objects[c.second].shape.closed, firstIsOpen = !objects[c.first].shape.closed;
      if (!secondIsOpen && !firstIsOpen) continue;
      const std::uint32_t which = secondIsOpen ? c.second : c.first;
      const Object& object = objects[which];
      const Value* entry = entryOf(object);
      if (!entry || std::find(moved.begin(), moved.end(), which) != moved.end()) continue;
      const Object& other = objects[which == c.second ? c.first : c.second];
      // Towards where the other surface is seen from.
      const Vec3 normal = visibleNormal(c, which);
      Value changed = *entry, step;
      const double unit = metresPerUnit();
      step.set("translate", Value::Array{normal.x * lift / unit, normal.y * lift / unit, normal.z * lift / unit});
      Value transform = changed.find("transform") ? *changed.find("transform") : Value(Value::Array{});
      transform.push(step);
      changed.set("transform", std::move(transform));
      text_.replace(*entry, changed);
      moved.push_back(which);
      done_.push_back(fmt::format("\"{}\" lifted off \"{}\" by {:.2g} mm", object.name, other.name, lift * 1000));
    }
  }

  [[nodiscard]] Vec3 visibleNormal(const geometry::Coincidence& c, std::uint32_t moved) const {
    // Of the first object's face; when that one is moved, the faces are parallel and the scene's middle decides.
    if (moved == c.second && project_.environment.objects[c.first].shape.closed) return c.normal;
    geometry::Bounds whole;
    for (const Object& object : project_.environment.objects)
      whole.add(geometry::bounds(object.shape, object.transform));
    return glm::dot(whole.center() - c.place, c.normal) < 0 ? -c.normal : c.normal;
  }

  [[nodiscard]] double metresPerUnit() const {
    const std::map<std::string, double> metres{{"mm", 1e-3}, {"cm", 1e-2}, {"ft", 0.3048}, {"in", 0.0254}};
    const auto found = metres.find(project_.units);
    return found == metres.end() ? 1.0 : found->second;
  }

  void mend(const Object& object) {
    const Value* entry = entryOf(object);
    if (!entry || object.shape.closed || object.shape.mesh.triangles.empty()) return;
    const Value* shape = entry->find("shape");
    if (!shape || !shape->isString() || shape->string() != "mesh") return;
    geometry::Mesh mesh = object.shape.mesh;
    geometry::mergeVertices(mesh, widestCrack * glm::length(geometry::boundsOf(mesh).extent()));
    geometry::removeCollapsedTriangles(mesh);
    removeDoubles(mesh);
    if (!geometry::orientOutward(mesh).watertight()) return;
    const std::string relative = "models/" + project::fileNameFor(object.name) + "-mended.obj";
    models_[(fs::path(project_.folder) / relative).string()] = geometry::objText(mesh, object.shape.partNames);
    Value changed = *entry;
    changed.set("file", relative);
    changed.set("units", "m");
    changed.set("up", "z");
    text_.replace(*entry, changed);
    done_.push_back(fmt::format("\"{}\" closed: cracks joined, doubled triangles taken out", object.name));
  }

  const project::Project& project_;
  std::string file_;
  project::ProjectText text_;
  std::map<std::string, std::string> models_;
  std::vector<std::string> done_;
};

}  // namespace

std::vector<std::string> repairProject(const project::Project& project, const std::string& file) {
  std::error_code ignored;
  if (fs::exists(file, ignored))
    throw core::InputError({file, 0, 0}, "exists", "this file is there already; give --fix another name");
  if (fs::absolute(fs::path(file)).parent_path().lexically_normal() !=
      fs::absolute(fs::path(project.folder)).lexically_normal())
    throw core::InputError({file, 0, 0}, "usage",
                           "the mended project must stand in the project's own folder, for its paths to hold");
  return Repair(project, file).run();
}

}  // namespace goniolux::pipeline
