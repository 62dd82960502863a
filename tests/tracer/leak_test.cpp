// No ray leaves a closed room, near the project's origin or far from it, in millimetres or in hundreds of metres.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/random.h"
#include "geometry/inside.h"
#include "geometry/objects.h"
#include "geometry/queries.h"
#include "scene/world.h"
#include "tracer/tracer.h"

namespace goniolux::tracer {
namespace {

using core::Vec3;

scene::Environment furnishedRoom(double scale, const Vec3& shift) {
  scene::Environment environment;
  material::Material paint;
  paint.name = "paint";
  paint.model = "lambert";
  paint.spectra["diffuse"] = spectrum::SpectralDistribution::flat(0.5);
  environment.materials = {paint};
  const auto box = [&](const Vec3& low, const Vec3& high) {
    scene::Object object;
    object.shape = geometry::findObjectType("box")->make({{"min", low * scale + shift}, {"max", high * scale + shift}});
    object.materials.assign(object.shape.partNames.size(), 0);
    environment.objects.push_back(object);
  };
  box({0, 0, 0}, {6, 4, 3});
  box({3.7, 0.9, 0.72}, {5.3, 1.7, 0.75});
  box({0, 0.6, 0}, {0.4, 1.8, 1.8});
  return environment;
}

struct Place {
  double scale;
  Vec3 shift;
};

class ClosedRoomLeaks : public testing::TestWithParam<Place> {};

TEST_P(ClosedRoomLeaks, NoRayEscapesInAMillionBounces) {
  const auto [scale, shift] = GetParam();
  const scene::World world = scene::buildWorld(furnishedRoom(scale, shift));
  const Tracer tracer(world);
  int escaped = 0;
  for (std::uint32_t path = 0; path < 50000; ++path) {
    core::Sampler random(7, path);
    Vec3 origin = Vec3(3, 3, 2) * scale + shift - world.origin;
    Vec3 normal(0, 0, 1);
    for (int bounce = 0; bounce < 20; ++bounce) {
      const core::Vec2 u = random.next2();
      const double z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0, 1 - z * z)), angle = 2 * core::pi * u.y;
      Vec3 direction(r * std::cos(angle), r * std::sin(angle), z);
      if (bounce > 0 && glm::dot(direction, normal) < 0) direction = -direction;
      Hit hit;
      if (!tracer.intersect(origin, direction, hit)) {
        ++escaped;
        break;
      }
      normal = glm::dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal;
      origin = tracer.leave(hit.position, normal);
    }
  }
  EXPECT_EQ(escaped, 0);
}

INSTANTIATE_TEST_SUITE_P(Scales, ClosedRoomLeaks,
                         testing::Values(Place{1, Vec3(0)}, Place{1, Vec3(1e5, -2e5, 300)}, Place{1e-3, Vec3(0)},
                                         Place{1e3, Vec3(0)}));

// Closed shapes of every kind as rooms. Rays go from wall to wall; from every wall one more is aimed at an edge between
// triangles, a vertex or a rim where patches meet. GONIOLUX_RAYS=1e8 runs the full count (some minutes) and prints the
// rate; GONIOLUX_ROOMS=revolution only those of a type.
//
// A ray that starts within its offset of a sharp edge starts beyond the next wall: the stated rate is that of the shape
// with the sharpest edges, with half of the rays aimed at edges.
constexpr double statedRate = 2e-6;

struct RoomKind {
  const char* type;
  core::Arguments arguments;
};

std::vector<RoomKind> closedRooms() {
  std::vector<std::vector<Vec3>> ball;  // a closed, bulging parametric surface: rows run from pole to pole
  for (int i = 0; i <= 6; ++i) {
    ball.emplace_back();
    const double polar = core::pi * i / 6;
    for (int j = 0; j <= 8; ++j) {
      const double angle = 2 * core::pi * (j % 8) / 8, r = i % 6 == 0 ? 0 : 2 * std::sin(polar);
      ball.back().emplace_back(r * std::cos(angle), r * std::sin(angle), -2 * std::cos(polar));
    }
  }
  return {
      {"box", {{"min", Vec3(0)}, {"max", Vec3(6, 4, 3)}}},
      {"polyhedron",
       {{"vertices", std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}, {4, 6, 0}, {0, 6, 0}, {2, 0, 1.5}, {2, 6, 1.5}}},
        {"faces", std::vector<std::vector<int>>{{0, 3, 2, 1}, {0, 1, 4}, {2, 5, 3}, {1, 2, 5, 4}, {0, 4, 5, 3}}}}},
      {"sphere", {{"center", Vec3(1, 2, 3)}, {"radius", 3.0}}},
      {"cylinder", {{"base", Vec3(1, 1, 0)}, {"top", Vec3(2, 2, 5)}, {"radius", 1.5}}},
      {"cone", {{"base", Vec3(0)}, {"height", 4.0}, {"radius", 3.0}, {"top_radius", 0.5}}},
      {"cone", {{"base", Vec3(0)}, {"height", 4.0}, {"radius", 3.0}, {"top_radius", 0.0}}},
      {"torus", {{"center", Vec3(0)}, {"axis", Vec3(1, 2, 2)}, {"ring_radius", 3.0}, {"tube_radius", 1.2}}},
      {"quadric",
       {{"xx", 1.0},
        {"yy", 2.0},
        {"zz", 3.0},
        {"xy", 0.5},
        {"constant", -4.0},
        {"size", 1.0},
        {"min", Vec3(-4)},
        {"max", Vec3(4)}}},
      {"revolution",
       {{"profile", std::vector<core::Vec2>{{0, 0}, {3, 0}, {2, 2}, {2.5, 3}, {0, 4}}}, {"axis", Vec3(0, 1, 2)}}},
      {"revolution",
       {{"profile", std::vector<core::Vec2>{{0, 0}, {2, 1}, {1.5, 3}, {0, 4}}}, {"curve", std::string("spline")}}},
      {"parametric", {{"control", ball}, {"basis", std::string("bspline")}, {"chord_error", 0.01}}},
  };
}

// A point of the shape's edges: of triangles, or rims of patches; the middle of the box where there are none.
Vec3 edgePoint(const geometry::Shape& shape, core::Sampler& random) {
  const core::Vec2 u = random.next2(), v = random.next2();
  if (!shape.mesh.triangles.empty()) {
    const auto& t = shape.mesh.triangles[static_cast<std::size_t>(u.x * double(shape.mesh.triangles.size()))];
    const auto k = static_cast<std::size_t>(u.y * 3);
    // Vertices exactly, now and then.
    const double s = v.y < 0.1 ? std::round(v.x) : v.x;
    return (1 - s) * shape.mesh.vertices[t[k]] + s * shape.mesh.vertices[t[(k + 1) % 3]];
  }
  const auto& patch = shape.patches[static_cast<std::size_t>(u.x * double(shape.patches.size()))];
  const double angle = 2 * core::pi * v.x;
  using Kind = geometry::QuadricPatch::Kind;
  if (patch.kind == Kind::disc || patch.kind == Kind::cylinder || patch.kind == Kind::cone)
    return Vec3(patch.placement * glm::dvec4(std::cos(angle), std::sin(angle), 0, 1));
  return Vec3(patch.placement[3]);
}

Vec3 placeInside(const geometry::Shape& shape, const core::Mat4& transform) {
  const geometry::InsideTest inside(shape, transform);
  const geometry::Bounds box = geometry::bounds(shape, transform);
  for (std::uint32_t i = 0;; ++i) {
    core::Sampler random(3, i);
    const core::Vec2 u = random.next2();
    const Vec3 p = box.min + Vec3(u.x, u.y, random.next()) * box.extent();
    if (inside.contains(p, 1e-3 * glm::length(box.extent()))) return p;
  }
}

class EveryClosedShape : public testing::TestWithParam<Place> {};

TEST_P(EveryClosedShape, LetsNoRayOutAtAnyScaleAndFarFromTheOrigin) {
  const char* asked = std::getenv("GONIOLUX_RAYS");
  const double total = asked ? std::atof(asked) : 2.2e5;
  const auto rooms = closedRooms();
  const auto raysPerRoom = static_cast<std::uint64_t>(total / double(rooms.size()));
  const char* only = std::getenv("GONIOLUX_ROOMS");
  for (const RoomKind& kind : rooms) {
    if (only && std::string(only) != kind.type) continue;
    scene::Environment environment;
    material::Material paint;
    paint.model = "lambert";
    environment.materials = {paint};
    scene::Object object;
    object.shape = geometry::findObjectType(kind.type)->make(kind.arguments);
    ASSERT_TRUE(object.shape.closed) << kind.type;
    object.transform = core::Mat4(core::Mat3(GetParam().scale));
    object.transform[3] = glm::dvec4(GetParam().shift, 1);
    object.materials = std::vector<std::uint32_t>(object.shape.partNames.size(), 0);
    environment.objects = {object};
    const scene::World world = scene::buildWorld(environment);
    const Tracer tracer(world);
    const Vec3 start = placeInside(object.shape, object.transform) - world.origin;
    std::uint64_t escaped = 0, wrongSide = 0, rays = 0;
    for (std::uint32_t path = 0; rays < raysPerRoom; ++path) {
      Vec3 origin = start, normal(0);
      for (std::uint32_t bounce = 0; bounce < 50; ++bounce, ++rays) {
        core::Sampler random(core::combine(7, bounce), path);
        const core::Vec2 u = random.next2();
        const double z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0, 1 - z * z)), angle = 2 * core::pi * u.y;
        Vec3 direction(r * std::cos(angle), r * std::sin(angle), z);
        const bool aimed = bounce % 2 == 1;
        if (aimed) {
          const Vec3 target = Vec3(object.transform * glm::dvec4(edgePoint(object.shape, random), 1)) - world.origin;
          direction = glm::normalize(target - origin);
          if (glm::dot(direction, normal) < 1e-3) continue;  // an edge of the wall that it stands on
        } else if (bounce > 0 && glm::dot(direction, normal) < 0) {
          direction = -direction;
        }
        Hit hit;
        if (!tracer.intersect(origin, direction, hit)) {
          ++escaped;
          if (aimed) continue;
          break;
        }
        wrongSide += glm::dot(hit.normal, direction) < -1e-6;
        if (aimed) continue;  // what begins on an edge lies, to rounding, on both sides of the next wall
        normal = glm::dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal;
        origin = tracer.leave(hit.position, normal);
      }
    }
    if (asked)
      std::printf("%-11s scale %g: %.3g rays, %llu escaped, %llu met a wall from outside\n", kind.type,
                  GetParam().scale, double(rays), static_cast<unsigned long long>(escaped),
                  static_cast<unsigned long long>(wrongSide));
    const auto most = asked ? static_cast<std::uint64_t>(statedRate * double(rays)) : 0;
    EXPECT_LE(escaped, most) << kind.type;
    EXPECT_LE(wrongSide, most) << kind.type;
  }
}

INSTANTIATE_TEST_SUITE_P(Scales, EveryClosedShape,
                         testing::Values(Place{1, Vec3(0)}, Place{1e-3, Vec3(0)}, Place{1e5, Vec3(0)},
                                         Place{1, Vec3(3e6, -5e6, 1e4)}));

TEST(Tracer, SeesWhatIsBetweenTwoPointsAndNothingElse) {
  const scene::World world = scene::buildWorld(furnishedRoom(1, Vec3(0)));
  const Tracer tracer(world);
  const Vec3 underTable = Vec3(4.5, 1.3, 0.4) - world.origin, up(0, 0, 1);
  EXPECT_TRUE(tracer.occluded(underTable, up, 1.0));
  EXPECT_FALSE(tracer.occluded(underTable, up, 0.3));
  EXPECT_FALSE(tracer.occluded(Vec3(2, 3, 0.4) - world.origin, up, 2.5));
  Hit hit;
  ASSERT_TRUE(tracer.intersect(underTable, up, hit));
  EXPECT_NEAR(hit.distance, 0.32, 1e-6);
  EXPECT_NEAR(std::abs(hit.normal.z), 1, 1e-12);
}

}  // namespace
}  // namespace goniolux::tracer
