#include "scene/surface_detail.h"

#include <algorithm>
#include <cmath>

#include "geometry/texture_coordinates.h"

namespace goniolux::scene {

using core::Mat3;
using core::Mat4;
using core::Vec2;
using core::Vec3;

namespace {

// Least cosine between a shown normal and the way to the eye: what leans away is not seen.
constexpr double leastFacing = 0.02;

struct Triangle {
  Vec3 a, b, c;  // world
  const Corners* corners = nullptr;
};

bool triangleOf(const World& world, const SurfacePoint& point, Triangle& triangle) {
  if (point.mesh != none) {
    const InstancedMesh& mesh = world.instanced[point.mesh];
    const auto& t = mesh.triangles[point.meshTriangle];
    const auto corner = [&](std::size_t k) {
      return Vec3(mesh.places[point.place] * glm::dvec4(mesh.vertices[t[k]], 1));
    };
    triangle = {corner(0), corner(1), corner(2), mesh.corners.empty() ? nullptr : &mesh.corners[point.meshTriangle]};
    return true;
  }
  if (point.primitive >= world.triangles.size()) return false;
  const auto& t = world.triangles[point.primitive];
  triangle = {world.vertices[t[0]], world.vertices[t[1]], world.vertices[t[2]]};
  if (point.primitive < world.triangleCorners.size() && world.triangleCorners[point.primitive] != none)
    triangle.corners = &world.corners[world.triangleCorners[point.primitive]];
  return true;
}

// Weights of the three corners for a place of the triangle's plane.
Vec3 barycentric(const Triangle& t, const Vec3& p) {
  const Vec3 u = t.b - t.a, v = t.c - t.a, w = p - t.a;
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), uw = glm::dot(u, w), vw = glm::dot(v, w);
  const double whole = uu * vv - uv * uv;
  if (!(whole > 0)) return {1, 0, 0};
  const double beta = (vv * uw - uv * vw) / whole, gamma = (uu * vw - uv * uw) / whole;
  return {1 - beta - gamma, beta, gamma};
}

Mat4 toObject(const World& world, const SurfacePoint& point) {
  if (point.mesh == none) return world.frames[world.surfaces[point.surface].frame];
  const InstancedMesh& mesh = world.instanced[point.mesh];
  Mat4 map = glm::inverse(mesh.places[point.place]);
  map[3] += glm::dvec4(mesh.middle, 0);
  return map;
}

// World normals of object normals: by the inverse transpose, here the transpose of world -> object.
Vec3 smoothNormal(const World& world, const SurfacePoint& point, const Triangle& triangle) {
  const Vec3 weights = glm::clamp(barycentric(triangle, point.position), 0.0, 1.0);
  Vec3 sum(0);
  for (int k = 0; k < 3; ++k) sum += weights[k] * Vec3(triangle.corners->normals[static_cast<std::size_t>(k)]);
  const Vec3 normal = glm::transpose(Mat3(toObject(world, point))) * sum;
  const double length = glm::length(normal);
  return length > 0 ? normal / length : point.normal;
}

// How the relief rises per metre along two directions of the surface.
Vec2 slopes(const World& world, const SurfacePoint& point, const texture::Relief& relief, const Vec3& x,
            const Vec3& y) {
  double step = relief.step();
  if (relief.projection.mapping == texture::Projection::Mapping::uv) {
    // So far that the coordinates change by the pattern's own step.
    const double trial = 1e-5 * world.radius;
    const Vec2 here = placeOn(world, point, point.position).coordinates;
    const double change = std::max(glm::distance(here, placeOn(world, point, point.position + trial * x).coordinates),
                                   glm::distance(here, placeOn(world, point, point.position + trial * y).coordinates));
    if (!(change > 0)) return {0, 0};
    step *= trial / change;
  }
  const auto height = [&](const Vec3& at) { return relief.heightAt(placeOn(world, point, at)); };
  const auto slope = [&](const Vec3& along) {
    return (height(point.position + step * along) - height(point.position - step * along)) / (2 * step);
  };
  return {slope(x), slope(y)};
}

}  // namespace

texture::SurfacePlace placeOn(const World& world, const SurfacePoint& point, const Vec3& at) {
  texture::SurfacePlace place;
  const Mat4 map = toObject(world, point);
  place.position = Vec3(map * glm::dvec4(at, 1));
  // Object normals from world normals: by the transpose of object -> world.
  place.normal = glm::normalize(glm::inverse(glm::transpose(Mat3(map))) * point.normal);
  Triangle triangle;
  if (triangleOf(world, point, triangle)) {
    if (triangle.corners == nullptr) return place;
    const Vec3 weights = barycentric(triangle, at);
    for (int k = 0; k < 3; ++k)
      place.coordinates += weights[k] * Vec2(triangle.corners->coordinates[static_cast<std::size_t>(k)]);
  } else {
    const PlacedPatch& patch = world.patches[point.primitive - world.triangles.size()];
    place.coordinates = geometry::surfaceCoordinates(patch.patch, Vec3(patch.toCanonical * glm::dvec4(at, 1)));
  }
  return place;
}

texture::Mixture mixtureAt(const World& world, const SurfacePoint& point) {
  const material::Material& finish = world.materials[world.surfaces[point.surface].material];
  return world.textures[*finish.texture]->at(placeOn(world, point, point.position));
}

Vec3 shownNormal(const World& world, const SurfacePoint& point, const Vec3& facing, const Vec3& out) {
  const Surface& surface = world.surfaces[point.surface];
  if (!surface.isDetailed) return facing;
  Vec3 normal = facing;
  Triangle triangle;
  if (triangleOf(world, point, triangle) && triangle.corners != nullptr &&
      glm::dot(triangle.corners->normals[0], triangle.corners->normals[0]) > 0) {
    normal = smoothNormal(world, point, triangle);
    if (glm::dot(point.normal, facing) < 0) normal = -normal;
  }
  if (const auto& relief = world.materials[surface.material].relief) {
    Vec3 x, y;
    core::perpendiculars(normal, x, y);
    const Vec2 rise = slopes(world, point, *world.reliefs[*relief], x, y);
    normal = glm::normalize(normal - rise.x * x - rise.y * y);
  }
  const double towards = glm::dot(normal, out);
  if (towards < leastFacing) normal = glm::normalize(normal + (leastFacing - towards) * out);
  return normal;
}

}  // namespace goniolux::scene
