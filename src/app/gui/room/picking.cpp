#include "app/gui/room/picking.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

namespace goniolux::gui {
namespace {

using core::Vec3;

/// Distance to the triangle; nothing when it is missed, or met from behind where only its front counts.
/// Moeller & Trumbore, Journal of Graphics Tools 2(1), 1997.
std::optional<double> hit(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c, bool frontOnly) {
  const Vec3 u = b - a, v = c - a, p = glm::cross(ray.direction, v);
  const double determinant = glm::dot(u, p);
  if (frontOnly ? determinant <= 1e-15 : std::abs(determinant) <= 1e-15) return std::nullopt;
  const Vec3 s = ray.origin - a, q = glm::cross(s, u);
  const double first = glm::dot(s, p) / determinant, second = glm::dot(ray.direction, q) / determinant;
  if (first < 0 || second < 0 || first + second > 1) return std::nullopt;
  const double distance = glm::dot(v, q) / determinant;
  return distance > ray.least && distance < ray.most ? std::optional(distance) : std::nullopt;
}

void pickSurface(const RoomScene& scene, vtkPolyData* data, const Ray& ray, bool frontOnly,
                 std::optional<Picked>& best) {
  vtkCellArray* cells = data->GetPolys();
  auto* objects = vtkIntArray::SafeDownCast(data->GetCellData()->GetArray("object"));
  vtkPoints* points = data->GetPoints();
  const vtkIdType count = cells->GetNumberOfCells();
  const auto at = [&](vtkIdType id) {
    double p[3];
    points->GetPoint(id, p);
    return Vec3(p[0], p[1], p[2]);
  };
  for (vtkIdType i = 0; i < count; ++i) {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(i, size, corners);
    const auto distance = hit(ray, at(corners[0]), at(corners[1]), at(corners[2]), frontOnly);
    if (!distance || (best && *distance >= best->distance)) continue;
    best = Picked{scene.objectPointers.at(static_cast<std::size_t>(objects->GetValue(i))), *distance, -1};
  }
}

}  // namespace

Ray Cut::of(Ray ray) const {
  const double side = takesGreater ? 1 : -1;
  const double beyond = side * (ray.origin[axis] - at), speed = side * ray.direction[axis];
  if (std::abs(speed) < 1e-12) {
    if (beyond > 0) ray.most = ray.least;
    return ray;
  }
  const double crossing = -beyond / speed;
  if (speed > 0) {
    ray.most = std::min(ray.most, crossing);
  } else {
    ray.least = std::max(ray.least, crossing);
  }
  return ray;
}

std::optional<Picked> pick(const RoomScene& scene, const Ray& ray, double reach, bool luminairesOnly) {
  std::optional<Picked> best;
  if (!luminairesOnly) {
    pickSurface(scene, scene.room, ray, true, best);
    for (const SurfacePiece& piece : scene.objects) pickSurface(scene, piece.data, ray, false, best);
  }
  // A luminaire flush with the surface behind it goes first.
  constexpr double flush = 0.05;
  std::optional<Picked> luminaire;
  for (std::size_t k = 0; k < scene.luminaires.size(); ++k) {
    const LuminaireMark& mark = scene.luminaires[k];
    std::optional<double> distance;
    for (std::size_t i = 2; i < mark.footprint.size() && !distance; ++i)
      distance = hit(ray, mark.footprint[0], mark.footprint[i - 1], mark.footprint[i], false);
    if (!distance) {
      const double along = glm::dot(mark.position - ray.origin, ray.direction);
      if (along > ray.least && along < ray.most &&
          glm::length(mark.position - ray.origin - along * ray.direction) < reach * along)
        distance = along;
    }
    if (distance && (!luminaire || *distance < luminaire->distance))
      luminaire = Picked{mark.pointer, *distance, static_cast<int>(k)};
  }
  if (luminaire && (!best || luminaire->distance < best->distance + flush)) return luminaire;
  return best;
}

std::optional<Vec3> onPlane(const Ray& ray, const Vec3& point, const Vec3& normal) {
  const double slope = glm::dot(ray.direction, normal);
  if (std::abs(slope) < 1e-6) return std::nullopt;
  const double distance = glm::dot(point - ray.origin, normal) / slope;
  if (distance <= 0) return std::nullopt;
  return ray.origin + distance * ray.direction;
}

Vec3 snapped(const Vec3& point, double step) {
  if (step <= 0) return point;
  // The division by a whole number keeps 0.1 steps at the digits that one would type.
  const double perMetre = 1 / step;
  Vec3 result;
  for (int k = 0; k < 3; ++k) result[k] = std::round(point[k] * perMetre) / perMetre;
  return result;
}

}  // namespace goniolux::gui
