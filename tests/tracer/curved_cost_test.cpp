// What exact intersection costs beside triangles: the figures of docs/decisions on curved surfaces. Prints nanoseconds
// per ray and the largest distance of a hit from the true surface; asserts only what cannot depend on the machine's
// load.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "core/random.h"
#include "geometry/objects.h"
#include "geometry/queries.h"
#include "geometry/tessellate.h"
#include "scene/world.h"
#include "tracer/tracer.h"

namespace goniolux::tracer {
namespace {

using core::Vec3;

struct Cost {
  double nanoseconds = 0;  ///< per ray
  double error = 0;        ///< m, largest distance of a hit from where the exact surface is hit
};

scene::World worldOf(const geometry::Shape& shape) {
  scene::Environment environment;
  material::Material paint;
  paint.model = "lambert";
  environment.materials = {paint};
  scene::Object object;
  object.shape = shape;
  object.materials.assign(shape.partNames.size(), 0);
  environment.objects = {object};
  return scene::buildWorld(environment);
}

std::vector<std::pair<Vec3, Vec3>> raysAt(const geometry::Shape& shape, int count) {
  const geometry::Bounds box = geometry::bounds(shape);
  const double radius = 0.5 * glm::length(box.extent());
  std::vector<std::pair<Vec3, Vec3>> rays;
  for (int i = 0; i < count; ++i) {
    core::Sampler random(5, static_cast<std::uint32_t>(i));
    const core::Vec2 u = random.next2(), v = random.next2();
    const auto onBall = [&](const core::Vec2& w) {
      const double z = 1 - 2 * w.x, r = std::sqrt(std::max(0.0, 1 - z * z));
      return radius * Vec3(r * std::cos(2 * core::pi * w.y), r * std::sin(2 * core::pi * w.y), z);
    };
    const Vec3 from = box.center() + 2.0 * onBall(u), to = box.center() + 0.5 * onBall(v);
    rays.emplace_back(from, glm::normalize(to - from));
  }
  return rays;
}

Cost measure(const geometry::Shape& exact, const geometry::Shape& shape) {
  const auto rays = raysAt(exact, 100'000);
  const scene::World world = worldOf(shape), exactWorld = worldOf(exact);
  const Tracer tracer(world), reference(exactWorld);
  Cost cost;
  Hit hit, there;
  const auto start = std::chrono::steady_clock::now();
  for (const auto& [origin, direction] : rays) tracer.intersect(origin - world.origin, direction, hit);
  cost.nanoseconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() * 1e9 / double(rays.size());
  for (const auto& [origin, direction] : rays) {
    if (!tracer.intersect(origin - world.origin, direction, hit) ||
        !reference.intersect(origin - exactWorld.origin, direction, there))
      continue;
    const double across = std::abs(glm::dot(direction, there.normal));
    if (across > 0.3) cost.error = std::max(cost.error, std::abs(hit.distance - there.distance) * across);
  }
  return cost;
}

TEST(CurvedSurfaces, ExactIntersectionIsFarCloserThanTrianglesAtAnyAffordableCount) {
  const std::vector<std::pair<const char*, core::Arguments>> shapes{
      {"sphere", {{"center", Vec3(0)}, {"radius", 1.0}}},
      {"cylinder", {{"base", Vec3(0)}, {"height", 2.0}, {"radius", 1.0}}},
      {"torus", {{"center", Vec3(0)}, {"ring_radius", 1.0}, {"tube_radius", 0.3}}},
      {"quadric",
       {{"xx", 1.0}, {"yy", 2.0}, {"zz", 3.0}, {"constant", -1.0}, {"size", 1.0}, {"min", Vec3(-2)}, {"max", Vec3(2)}}},
  };
  for (const auto& [type, arguments] : shapes) {
    const geometry::Shape exact = geometry::findObjectType(type)->make(arguments);
    const Cost own = measure(exact, exact);
    std::printf("%-9s exact: %4.0f ns per ray\n", type, own.nanoseconds);
    for (const int sides : {32, 128, 512}) {
      if (std::string(type) == "quadric" && sides > 128) continue;
      geometry::Shape twin;
      twin.partNames = exact.partNames;
      twin.mesh = geometry::tessellate(exact, sides);
      const Cost cost = measure(exact, twin);
      std::printf("%-9s as %7zu triangles: %4.0f ns per ray, off by up to %.1e m\n", type, twin.mesh.triangles.size(),
                  cost.nanoseconds, cost.error);
      EXPECT_GT(cost.error, 1e-6);
    }
  }
}

}  // namespace
}  // namespace goniolux::tracer
