// Findings that need rays: holes in the room, and luminaires right before a surface.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "geometry/queries.h"
#include "pipeline/geometry_findings.h"
#include "scene/world.h"
#include "tracer/tracer.h"

namespace goniolux::pipeline {
namespace {

using core::Vec3;

constexpr int raysPerPlace = 4096, placesPerGrid = 4;
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

 private:
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
}

}  // namespace goniolux::pipeline
