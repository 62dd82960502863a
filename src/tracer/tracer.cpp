#include "tracer/tracer.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/diagnostics.h"
#include "geometry/quadric_intersect.h"

namespace goniolux::tracer {

using core::Vec3;

namespace {

constexpr unsigned triangleGeometry = 0, patchGeometry = 1, firstInstance = 2;

Vec3 toCanonical(const scene::PlacedPatch& patch, const Vec3& v, double w) {
  return Vec3(patch.toCanonical * glm::dvec4(v, w));
}

void patchBounds(const RTCBoundsFunctionArguments* args) {
  const auto* patches = static_cast<const scene::PlacedPatch*>(args->geometryUserPtr);
  const geometry::Bounds bounds = geometry::boundsOf(patches[args->primID].patch);
  const auto below = [](double x) { return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::max()); };
  const auto above = [](double x) { return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::max()); };
  RTCBounds& out = *args->bounds_o;
  out.lower_x = below(bounds.min.x), out.lower_y = below(bounds.min.y), out.lower_z = below(bounds.min.z);
  out.upper_x = above(bounds.max.x), out.upper_y = above(bounds.max.y), out.upper_z = above(bounds.max.z);
}

bool hitPatch(const scene::PlacedPatch& patch, float ox, float oy, float oz, float dx, float dy, float dz, float near,
              float far, double& t) {
  return geometry::intersect(patch.patch, toCanonical(patch, Vec3(ox, oy, oz), 1),
                             toCanonical(patch, Vec3(dx, dy, dz), 0), near, far, t);
}

void intersectPatch(const RTCIntersectFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const auto* patches = static_cast<const scene::PlacedPatch*>(args->geometryUserPtr);
  auto* rayhit = reinterpret_cast<RTCRayHit*>(args->rayhit);
  RTCRay& ray = rayhit->ray;
  double t;
  if (!hitPatch(patches[args->primID], ray.org_x, ray.org_y, ray.org_z, ray.dir_x, ray.dir_y, ray.dir_z, ray.tnear,
                ray.tfar, t))
    return;
  ray.tfar = static_cast<float>(t);
  rayhit->hit.primID = args->primID;
  rayhit->hit.geomID = args->geomID;
  rayhit->hit.instID[0] = args->context->instID[0];
}

void occludedPatch(const RTCOccludedFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const auto* patches = static_cast<const scene::PlacedPatch*>(args->geometryUserPtr);
  auto& ray = *reinterpret_cast<RTCRay*>(args->ray);
  double t;
  if (hitPatch(patches[args->primID], ray.org_x, ray.org_y, ray.org_z, ray.dir_x, ray.dir_y, ray.dir_z, ray.tnear,
               ray.tfar, t))
    ray.tfar = -std::numeric_limits<float>::infinity();
}

RTCRay makeRay(const Vec3& origin, const Vec3& direction, double distance) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(origin.x), ray.org_y = static_cast<float>(origin.y);
  ray.org_z = static_cast<float>(origin.z);
  ray.dir_x = static_cast<float>(direction.x), ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tnear = 0;
  ray.tfar = static_cast<float>(distance);
  ray.mask = ~0u;
  return ray;
}

RTCGeometry triangleGeometryOf(RTCDevice device, const std::vector<Vec3>& points,
                               const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), points.size()));
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
  if (vertices == nullptr || indices == nullptr) throw core::RunError("out of memory for the ray tracer's triangles");
  for (const Vec3& v : points)
    for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(v[axis]);
  for (const auto& triangle : triangles)
    for (const std::uint32_t corner : triangle) *indices++ = corner;
  rtcCommitGeometry(geometry);
  return geometry;
}

}  // namespace

struct Tracer::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<RTCScene> meshes;  // of World::instanced
  ~Embree() {
    for (RTCScene mesh : meshes) rtcReleaseScene(mesh);
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

Tracer::Tracer(const scene::World& world) : embree_(std::make_unique<Embree>()), world_(world) {
  // Coordinates are rounded to 2^-24 of their size when they become single precision, at the start of a ray and in the
  // triangles; 32 such steps of the farthest point were enough in all closed rooms tried (tests/tracer/leak_test.cpp).
  offset_ = std::ldexp(world.radius, -19);

  embree_->device = rtcNewDevice("threads=1,start_threads=0");
  if (embree_->device == nullptr) throw core::RunError("the ray tracer could not start (Embree gave no device)");
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips between triangles that share an edge

  if (!world.triangles.empty()) {
    RTCGeometry geometry = triangleGeometryOf(embree_->device, world.vertices, world.triangles);
    rtcAttachGeometryByID(embree_->scene, geometry, triangleGeometry);
    rtcReleaseGeometry(geometry);
    triangleNormals_.reserve(world.triangles.size());
    for (const auto& t : world.triangles) {
      const Vec3 &a = world.vertices[t[0]], &b = world.vertices[t[1]], &c = world.vertices[t[2]];
      triangleNormals_.push_back(glm::normalize(glm::cross(b - a, c - a)));
    }
  }
  if (!world.patches.empty()) {
    RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(world.patches.size()));
    rtcSetGeometryUserData(geometry, const_cast<scene::PlacedPatch*>(world.patches.data()));
    rtcSetGeometryBoundsFunction(geometry, patchBounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersectPatch);
    rtcSetGeometryOccludedFunction(geometry, occludedPatch);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(embree_->scene, geometry, patchGeometry);
    rtcReleaseGeometry(geometry);
  }
  for (std::uint32_t m = 0; m < world.instanced.size(); ++m) {
    const scene::InstancedMesh& mesh = world.instanced[m];
    RTCScene child = rtcNewScene(embree_->device);
    embree_->meshes.push_back(child);
    rtcSetSceneFlags(child, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry triangles = triangleGeometryOf(embree_->device, mesh.vertices, mesh.triangles);
    rtcAttachGeometryByID(child, triangles, triangleGeometry);
    rtcReleaseGeometry(triangles);
    rtcCommitScene(child);
    for (std::uint32_t p = 0; p < mesh.places.size(); ++p) {
      RTCGeometry instance = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryInstancedScene(instance, child);
      float columns[16];
      for (int i = 0; i < 16; ++i) columns[i] = static_cast<float>(mesh.places[p][i / 4][i % 4]);
      rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, columns);
      rtcCommitGeometry(instance);
      rtcAttachGeometryByID(embree_->scene, instance, firstInstance + static_cast<unsigned>(instances_.size()));
      rtcReleaseGeometry(instance);
      instances_.push_back({m, p});
    }
  }
  rtcCommitScene(embree_->scene);
  if (const RTCError error = rtcGetDeviceError(embree_->device); error != RTC_ERROR_NONE)
    throw core::RunError(
        fmt::format("the ray tracer could not take the scene (Embree error {})", static_cast<int>(error)));
}

Tracer::~Tracer() = default;

bool Tracer::intersect(const Vec3& origin, const Vec3& direction, Hit& hit) const {
  RTCRayHit rayhit{};
  const auto trace = [&](const Vec3& from) {
    rayhit.ray = makeRay(from, direction, std::numeric_limits<float>::infinity());
    rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(embree_->scene, &context, &rayhit);
    return rayhit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  };
  if (!trace(origin)) {
    // Aimed at the very edge between two triangles, a few rays in 10^4 pass between them even in robust mode
    // (tests/tracer/leak_test.cpp): what meets nothing is tried once more, beside itself by an eighth of the offset.
    Vec3 x, y;
    core::perpendiculars(direction, x, y);
    if (!trace(origin + (0.125 * offset_) * (0.8 * x + 0.6 * y))) return false;
  }

  const std::uint32_t id = rayhit.hit.primID;
  hit.distance = rayhit.ray.tfar;
  hit.position = origin + direction * hit.distance;
  hit.mesh = scene::none;
  if (rayhit.hit.instID[0] != RTC_INVALID_GEOMETRY_ID) {
    finishInstanceHit(rayhit.hit.instID[0] - firstInstance, id, hit);
  } else if (rayhit.hit.geomID == triangleGeometry) {
    hit.primitive = id;
    hit.surface = world_.triangleSurfaces[id];
    hit.normal = triangleNormals_[id];
    // Back onto the triangle's plane: what single precision lost along the ray does not become a gap or a penetration.
    hit.position -= hit.normal * glm::dot(hit.position - world_.vertices[world_.triangles[id][0]], hit.normal);
  } else {
    const scene::PlacedPatch& patch = world_.patches[id];
    hit.primitive = static_cast<std::uint32_t>(world_.triangles.size()) + id;
    hit.surface = patch.surface;
    const Vec3 canonical = toCanonical(patch, hit.position, 1);
    hit.normal = glm::normalize(glm::transpose(core::Mat3(patch.toCanonical)) *
                                geometry::canonicalNormal(patch.patch, canonical));
  }
  return true;
}

void Tracer::finishInstanceHit(std::uint32_t instance, std::uint32_t triangle, Hit& hit) const {
  const scene::InstancedMesh& mesh = world_.instanced[instances_[instance].mesh];
  const core::Mat4& place = mesh.places[instances_[instance].place];
  const auto& t = mesh.triangles[triangle];
  const Vec3 a(place * glm::dvec4(mesh.vertices[t[0]], 1)), b(place * glm::dvec4(mesh.vertices[t[1]], 1)),
      c(place * glm::dvec4(mesh.vertices[t[2]], 1));
  hit.primitive = scene::none;
  hit.mesh = instances_[instance].mesh;
  hit.place = instances_[instance].place;
  hit.meshTriangle = triangle;
  hit.surface = mesh.triangleSurfaces[triangle];
  hit.normal = glm::normalize(glm::cross(b - a, c - a));
  hit.position -= hit.normal * glm::dot(hit.position - a, hit.normal);
}

core::Vec3 Tracer::clearOfCorners(Vec3 point, const Vec3& normal) const {
  Vec3 x, y;
  core::perpendiculars(normal, x, y);
  constexpr int directions = 8;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * core::pi * i / directions;
    const Vec3 direction = x * std::cos(angle) + y * std::sin(angle);
    Hit hit;
    if (!intersect(leave(point, normal), direction, hit) || hit.distance > 4 * offset_) continue;
    // Along that wall's normal, so that no step leads into a third wall; and within the point's own surface.
    const Vec3 away = glm::dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal;
    const double gap = -hit.distance * glm::dot(direction, away);
    const Vec3 aside = away - normal * glm::dot(normal, away);
    const double sine = glm::length(aside);
    if (gap < 2 * offset_ && sine > 0.01) point += aside * ((2 * offset_ - gap) / (sine * sine));
  }
  return point;
}

bool Tracer::occluded(const Vec3& origin, const Vec3& direction, double distance) const {
  if (distance <= 0) return false;
  RTCRay ray = makeRay(origin, direction, distance);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &ray);
  return ray.tfar < 0;
}

std::string tracingLibrary() {
  return fmt::format("Embree {}.{}.{}", RTC_VERSION_MAJOR, RTC_VERSION_MINOR, RTC_VERSION_PATCH);
}

}  // namespace goniolux::tracer
