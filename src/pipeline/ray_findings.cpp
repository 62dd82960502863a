// Findings that need rays: holes in the room, luminaires right before a surface, grid points on faces that they do not
// look away from, and surfaces that run through each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/random.h"
#include "geometry/queries.h"
#include "geometry/tessellate.h"
#include "pipeline/geometry_findings.h"
#include "scene/world.h"
#include "tracer/tracer.h"

namespace goniolux::pipeline {
namespace {

using core::Vec3;

constexpr int raysPerPlace = 4096, placesPerGrid = 4;
constexpr std::size_t mostEdges = 2'000'000;  // followed through other surfaces
constexpr std::size_t mostPairs = 3;          // of surfaces that run through each other, named one by one
constexpr int sidesOfRound = 24;
constexpr double nearest = 0.02;  // m: closer than that before a luminaire, a surface is no furniture

Vec3 direction(const core::Vec2& u) {
  const double z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0, 1 - z * z)), angle = 2 * core::pi * u.y;
  return {r * std::cos(angle), r * std::sin(angle), z};
}

class Rays {
 public:
  Rays(const project::Project& project, core::Diagnostics& found)
      : project_(project), found_(found), world_(scene::buildWorld(project.environment)), tracer_(world_) {}

  void holes() {
    for (const analysis::Grid& grid : project_.grids) {
      const std::size_t step = std::max<std::size_t>(1, grid.points.size() / placesPerGrid);
      std::size_t rays = 0, escaped = 0;
      Vec3 through(0), from(0);
      for (std::size_t i = step / 2; i < grid.points.size(); i += step) {
        const Vec3 origin = grid.points[i] - world_.origin + 1e-5 * world_.radius * grid.normals[i];
        for (int k = 0; k < raysPerPlace; ++k, ++rays) {
          core::Sampler random(core::combine(17, i), static_cast<std::uint32_t>(k));
          const Vec3 d = direction(random.next2());
          tracer::Hit hit;
          if (tracer_.intersect(origin, d, hit)) continue;
          if (escaped++ == 0) from = origin, through = exitOf(origin, d);
        }
      }
      if (escaped == 0 || rays == 0) continue;
      found_.warning(
          grid.position, "open-room",
          fmt::format("{:.2g} % of the directions seen from the grid \"{}\" leave the scene, for example from "
                      "{} through {}: light is lost there; close the gap unless it is meant",
                      100.0 * double(escaped) / double(rays), grid.name, placeText(from + world_.origin),
                      placeText(through + world_.origin)));
      return;  // the other grids see the same holes
    }
  }

  void blockedLuminaires() {
    for (const scene::Luminaire& luminaire : project_.environment.luminaires) {
      const Vec3 aim = luminaire.frame.aim;
      // From the middle of the opening out of it: what belongs to a luminaire does not count.
      Vec3 origin = luminaire.center - world_.origin + 1e-4 * aim;
      tracer::Hit hit;
      bool found = tracer_.intersect(origin, aim, hit);
      for (int k = 0; k < 4 && found && world_.surfaces[hit.surface].object == scene::none; ++k) {
        origin = hit.position + 1e-4 * aim;
        found = tracer_.intersect(origin, aim, hit);
      }
      if (!found || hit.distance > nearest) continue;
      const std::uint32_t object = world_.surfaces[hit.surface].object;
      if (object == scene::none) continue;
      const scene::Object& blocking = project_.environment.objects[object];
      found_.warning(luminaire.position, "blocked",
                     fmt::format("\"{}\" (line {}) is {:.2g} m before the luminaire \"{}\", at {}: its light does not "
                                 "come out; move the luminaire, or turn its \"aim\"",
                                 blocking.name, blocking.position.line, hit.distance, luminaire.name,
                                 placeText(hit.position + world_.origin)));
    }
  }

  // Which side of a face a point in it lies on is a matter of rounding, unless it looks away from that face.
  void pointsOnFaces() {
    const double reach = 4 * tracer_.slack();
    for (const analysis::Grid& grid : project_.grids) {
      std::map<std::uint32_t, std::pair<std::size_t, Vec3>> touched;  // by object: how many points, the first
      for (std::size_t i = 0; i < grid.points.size(); ++i) {
        const Vec3 point = grid.points[i] - world_.origin;
        Vec3 x, y;
        core::perpendiculars(grid.normals[i], x, y);
        for (const Vec3& d : {x, -x, y, -y, grid.normals[i]}) {
          tracer::Hit hit;
          if (!tracer_.intersect(point - reach * d, d, hit) || hit.distance > 2 * reach) continue;
          const std::uint32_t object = world_.surfaces[hit.surface].object;
          if (object == scene::none) continue;
          const double inward = project_.environment.objects[object].facesInward ? -1 : 1;
          const double away = inward * glm::dot(hit.normal, grid.normals[i]);
          if (!project_.environment.objects[object].shape.closed ? std::abs(away) > 0.7 : away > 0.7) continue;
          auto& entry = touched.try_emplace(object, 0, grid.points[i]).first->second;
          ++entry.first;
          break;
        }
      }
      for (const auto& [index, entry] : touched) {
        const scene::Object& object = project_.environment.objects[index];
        found_.warning(grid.position, "on-face",
                       fmt::format("{} of {} points of the grid \"{}\" lie in a face of \"{}\" (line {}), the first at "
                                   "{}: on which side of it they count is a matter of rounding; move the grid or the "
                                   "object by a millimetre",
                                   entry.first, grid.points.size(), grid.name, object.name, object.position.line,
                                   placeText(entry.second)));
      }
    }
  }

  // Surfaces run through each other where an edge of one pierces the other.
  void intersections() {
    const auto& objects = project_.environment.objects;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> pairs;
    std::size_t edges = 0;
    for (std::uint32_t i = 0; i < objects.size(); ++i) {
      if (objects[i].facesInward || !objects[i].copies.empty()) continue;
      const geometry::Mesh mesh = geometry::tessellate(objects[i].shape, sidesOfRound);
      edges += 3 * mesh.triangles.size();
      if (edges > mostEdges) {
        found_.warning(objects[i].position, "not-compared",
                       fmt::format("from \"{}\" on there are so many triangles that objects were not searched for "
                                   "surfaces that run through each other",
                                   objects[i].name));
        break;
      }
      for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
          if (objects[i].shape.closed && t[k] > t[(k + 1) % 3]) continue;  // its neighbour's
          const auto place = [&](std::uint32_t vertex) {
            return Vec3(objects[i].transform * glm::dvec4(mesh.vertices[vertex], 1)) - world_.origin;
          };
          followEdge(i, place(t[k]), place(t[(k + 1) % 3]), pairs);
        }
    }
    if (pairs.empty()) return;
    std::string list;
    std::size_t listed = 0;
    for (const auto& [pair, where] : pairs) {
      if (listed++ == mostPairs) break;
      const scene::Object &first = objects[pair.first], &second = objects[pair.second];
      list += fmt::format("{}\"{}\" (line {}) and \"{}\" (line {}) at {}", listed > 1 ? "; " : "", first.name,
                          first.position.line, second.name, second.position.line, placeText(where + world_.origin));
    }
    if (pairs.size() > mostPairs) list += fmt::format("; and {} pairs more", pairs.size() - mostPairs);
    const auto& [pair, where] = *pairs.begin();
    found_.warning(objects[pair.second].position, "intersecting",
                   "surfaces run through each other: " + list + "; among opaque objects no light is lost");
  }

 private:
  void followEdge(std::uint32_t own, const Vec3& from, const Vec3& to,
                  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3>& pairs) const {
    constexpr int mostCrossed = 64;
    const double length = glm::distance(from, to), depth = std::max(8 * tracer_.slack(), 1e-4);
    if (!(length > 2 * depth)) return;
    const Vec3 d = (to - from) / length;
    Vec3 origin = from;
    for (int k = 0; k < mostCrossed; ++k) {
      tracer::Hit hit;
      if (!tracer_.intersect(origin, d, hit)) return;
      const double along = glm::dot(hit.position - from, d);
      if (along >= length) return;
      const std::uint32_t object = world_.surfaces[hit.surface].object;
      const auto away = [&](const Vec3& end) { return std::abs(glm::dot(end - hit.position, hit.normal)); };
      if (object != scene::none && object != own && away(from) > depth && away(to) > depth &&
          !project_.environment.objects[object].facesInward && isPierced(object, hit, d, depth))
        pairs.try_emplace({std::min(own, object), std::max(own, object)}, hit.position);
      origin = from + d * (along + 2 * tracer_.slack());
    }
  }

  // All about the hit, too, an edge that runs the same way would meet the object: what touches along a border does not.
  [[nodiscard]] bool isPierced(std::uint32_t object, const tracer::Hit& hit, const Vec3& d, double depth) const {
    Vec3 x, y;
    core::perpendiculars(d, x, y);
    const double steepness = std::max(0.05, std::abs(glm::dot(d, hit.normal))), reach = 2 * depth / steepness;
    for (const Vec3& aside : {x, -x, y, -y}) {
      tracer::Hit other;
      if (!tracer_.intersect(hit.position + depth * aside - reach * d, d, other) || other.distance > 2 * reach ||
          world_.surfaces[other.surface].object != object)
        return false;
    }
    return true;
  }

  // Where a ray leaves the box about everything.
  [[nodiscard]] Vec3 exitOf(const Vec3& origin, const Vec3& d) const {
    geometry::Bounds box;
    for (const scene::Object& object : project_.environment.objects) {
      const geometry::Bounds own = geometry::bounds(object.shape, object.transform);
      if (!own.empty()) box.add(own);
    }
    double t = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis) {
      if (d[axis] == 0) continue;
      const double wall = (d[axis] > 0 ? box.max[axis] : box.min[axis]) - world_.origin[axis];
      t = std::min(t, std::max(0.0, (wall - origin[axis]) / d[axis]));
    }
    return origin + t * d;
  }

  const project::Project& project_;
  core::Diagnostics& found_;
  scene::World world_;
  tracer::Tracer tracer_;
};

}  // namespace

void findByRays(const project::Project& project, core::Diagnostics& found) {
  Rays rays(project, found);
  rays.holes();
  rays.blockedLuminaires();
  rays.pointsOnFaces();
  rays.intersections();
}

}  // namespace goniolux::pipeline
