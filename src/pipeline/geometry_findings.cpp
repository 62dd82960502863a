#include "pipeline/geometry_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/inside.h"
#include "geometry/queries.h"
#include "geometry/tessellate.h"
#include "scene/housing.h"

namespace goniolux::pipeline {
namespace {

using core::Mat4;
using core::Vec3;
using geometry::Bounds;
using scene::Object;

constexpr double sliverHeight = 1e-4;           // over the longest edge
constexpr std::size_t mostComparedFaces = 2e6;  // coincidence: beyond it the largest objects are left out
constexpr int facetsOfDiscs = 48;

Vec3 apply(const Mat4& map, const Vec3& point) {
  return Vec3(map * glm::dvec4(point, 1));
}

class Findings {
 public:
  Findings(const project::Project& project, core::Diagnostics& found) : project_(project), found_(found) {
    for (const Object& object : project.environment.objects) {
      Bounds box;
      for (const Mat4& place : scene::placesOf(object)) box.add(geometry::bounds(object.shape, place));
      boxes_.push_back(box);
      whole_.add(box);
      if (object.facesInward) rooms_.add(box);
    }
    tolerance_ = 2e-6 * std::max(glm::length(whole_.extent()), 1e-9);
  }

  void all() {
    scale();
    for (std::size_t i = 0; i < objects().size(); ++i) {
      slivers(objects()[i]);
      openGlass(objects()[i]);
      outOfTheRoom(objects()[i], boxes_[i]);
    }
    coincidences();
    inObjects();
  }

 private:
  [[nodiscard]] const std::vector<Object>& objects() const { return project_.environment.objects; }
  void warn(const core::SourcePosition& position, const char* rule, std::string message) {
    found_.warning(position, rule, std::move(message));
  }

  void scale() {
    const double size = glm::length((rooms_.empty() ? whole_ : rooms_).extent());
    if (size > 2000 || size < 0.05)
      warn({project_.file, 0, 0}, "scale",
           fmt::format("the scene measures {:.4g} m across; is \"units\": \"{}\" right, and that of imported meshes?",
                       size, project_.units));
    if (rooms_.empty()) return;
    for (std::size_t i = 0; i < objects().size(); ++i) {
      const double own = glm::length(boxes_[i].extent());
      if (!objects()[i].facesInward && own > 3 * size)
        warn(objects()[i].position, "scale",
             fmt::format("\"{}\" measures {:.4g} m across, the room {:.4g} m; check the mesh's \"units\"",
                         objects()[i].name, own, size));
    }
  }

  void slivers(const Object& object) {
    std::size_t count = 0;
    Vec3 where(0);
    const auto& mesh = object.shape.mesh;
    for (const auto& t : mesh.triangles) {
      const Vec3 a = apply(object.transform, mesh.vertices[t[0]]), b = apply(object.transform, mesh.vertices[t[1]]),
                 c = apply(object.transform, mesh.vertices[t[2]]);
      const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
      if (glm::length(glm::cross(b - a, c - a)) > sliverHeight * longest * longest) continue;
      if (count++ == 0) where = (a + b + c) / 3.0;
    }
    if (count > 0)
      warn(object.position, "sliver",
           fmt::format("\"{}\" has {} sliver triangle{} (thinner than 1/10000 of their length), the first at {}; their "
                       "normals are uncertain, mesh it anew",
                       object.name, count, count == 1 ? "" : "s", placeText(where)));
  }

  // A transparent body without an inside bends light at random: a thin pane says so by its thickness.
  void openGlass(const Object& object) {
    if (object.shape.closed) return;
    for (const std::uint32_t index : object.materials) {
      const material::Material& material = project_.environment.materials[index];
      if (material.model != "dielectric" || material.numbers.contains("thickness_m")) continue;
      warn(object.position, "open-glass",
           fmt::format("\"{}\" is of \"{}\", but its surface is not closed: it has no inside; close it, or give the "
                       "material a \"thickness_m\" for a thin pane",
                       object.name, material.name));
      return;
    }
  }

  void outOfTheRoom(const Object& object, const Bounds& box) {
    if (rooms_.empty() || object.facesInward || box.empty()) return;
    const Vec3 below = rooms_.min - box.min, above = box.max - rooms_.max;
    int axis = 0;
    double most = 0;
    bool isAbove = false;
    for (int k = 0; k < 3; ++k) {
      if (above[k] > most) most = above[k], axis = k, isAbove = true;
      if (below[k] > most) most = below[k], axis = k, isAbove = false;
    }
    if (most <= 10 * tolerance_) return;
    const double plane = isAbove ? rooms_.max[axis] : rooms_.min[axis];
    warn(object.position, "outside",
         fmt::format("\"{}\" reaches {:.4g} m out of the room through {} = {:.4g} m; what is outside is not lit",
                     object.name, most, "xyz"[axis], plane));
  }

  void addFaces(std::uint32_t index, std::vector<geometry::VisibleFace>& faces) {
    const Object& object = objects()[index];
    const auto add = [&](const geometry::Mesh& mesh, const Mat4& place) {
      const double side = (glm::determinant(core::Mat3(place)) < 0 ? -1.0 : 1.0) * (object.facesInward ? -1.0 : 1.0);
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        geometry::VisibleFace face;
        face.a = apply(place, mesh.vertices[t[0]]);
        face.b = apply(place, mesh.vertices[t[1]]);
        face.c = apply(place, mesh.vertices[t[2]]);
        const Vec3 normal = glm::cross(face.b - face.a, face.c - face.a);
        if (!(glm::length(normal) > 0)) continue;
        face.normal = side * glm::normalize(normal);
        face.bothSides = !object.shape.closed;
        face.object = index;
        face.finish = object.materials[mesh.parts[i]];
        faces.push_back(face);
      }
    };
    for (const Mat4& place : scene::placesOf(object)) {
      add(object.shape.mesh, place);
      for (const geometry::QuadricPatch& patch : object.shape.patches)
        if (patch.kind == geometry::QuadricPatch::Kind::disc) add(geometry::tessellate(patch, facetsOfDiscs), place);
    }
  }

  void coincidences() {
    for (const geometry::Coincidence& c : findCoincidences()) {
      const Object &first = objects()[c.first], &second = objects()[c.second];
      warn(second.position, "coincident",
           fmt::format("\"{}\" lies in the same plane as \"{}\" (line {}), both seen, at {}: which one light meets is "
                       "chance; move it by a millimetre",
                       second.name, first.name, first.position.line, placeText(c.place)));
    }
  }

 public:
  std::vector<geometry::Coincidence> findCoincidences() {
    std::vector<geometry::VisibleFace> faces;
    for (std::uint32_t i = 0; i < objects().size(); ++i) {
      const std::size_t own = objects()[i].shape.mesh.triangles.size() * (objects()[i].copies.size() + 1);
      if (faces.size() + own > mostComparedFaces) {
        warn(objects()[i].position, "not-compared",
             fmt::format("\"{}\" has so many triangles that it was not searched for coincident surfaces",
                         objects()[i].name));
        continue;
      }
      addFaces(i, faces);
    }
    return geometry::coincidentFaces(faces, tolerance_);
  }

 private:
  void inObjects() {
    for (const scene::Enclosure& enclosure : scene::enclosuresOf(project_.environment)) {
      const scene::Luminaire& luminaire = project_.environment.luminaires[enclosure.luminaire];
      const Object& object = objects()[enclosure.object];
      warn(luminaire.position, "inside-object",
           fmt::format("the luminaire \"{}\" at {} is inside \"{}\" (line {}): {}", luminaire.name,
                       placeText(luminaire.center), object.name, object.position.line,
                       enclosure.isHousing ? "taken for its housing, which does not shade its light"
                                           : "too large for its housing, so its light does not come out"));
    }

    for (std::size_t i = 0; i < objects().size(); ++i) {
      const Object& object = objects()[i];
      if (object.facesInward || !object.shape.closed) continue;
      for (const Mat4& place : scene::placesOf(object)) {
        const geometry::InsideTest test(object.shape, place);
        for (const analysis::Grid& grid : project_.grids) {
          std::size_t count = 0;
          Vec3 first(0);
          for (const Vec3& point : grid.points)
            if (test.contains(point) && count++ == 0) first = point;
          if (count > 0)
            warn(
                grid.position, "inside-object",
                fmt::format("{} of {} points of the grid \"{}\" are inside \"{}\" (line {}), the first at {}: they get "
                            "no value",
                            count, grid.points.size(), grid.name, object.name, object.position.line, placeText(first)));
        }
      }
    }
  }

  const project::Project& project_;
  core::Diagnostics& found_;
  std::vector<Bounds> boxes_;
  Bounds whole_, rooms_;
  double tolerance_ = 0;
};

}  // namespace

void findInGeometry(const project::Project& project, core::Diagnostics& found) {
  Findings(project, found).all();
}

std::vector<geometry::Coincidence> coincidencesOf(const project::Project& project, core::Diagnostics& found) {
  return Findings(project, found).findCoincidences();
}

std::string placeText(const Vec3& place) {
  const auto coordinate = [](double x) { return std::round(x * 1e4) / 1e4 + 0.0; };
  return fmt::format("({}, {}, {}) m", coordinate(place.x), coordinate(place.y), coordinate(place.z));
}

}  // namespace goniolux::pipeline
