#include "scene/covered_faces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace goniolux::scene {

using core::Vec3;
using emitter::Opening;

namespace {

constexpr double nearness = 0.05;  // of a face's shorter side

bool isWithin(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  return glm::dot(glm::cross(b - a, point - a), normal) >= 0 && glm::dot(glm::cross(c - b, point - b), normal) >= 0 &&
         glm::dot(glm::cross(a - c, point - c), normal) >= 0;
}

/// A face as five of its points, and which of them have a surface before them.
struct Face {
  int index;
  Vec3 normal;
  std::array<Vec3, 5> points;
  double nearest;
  std::array<bool, 5> met{};
};

void lookAt(Face& face, const Vec3& a, const Vec3& b, const Vec3& c) {
  // Most triangles lie elsewhere: one corner's height tells.
  if (std::abs(glm::dot(face.normal, a - face.points[0])) > face.nearest) return;
  const Vec3 across = glm::cross(b - a, c - a);
  const double twiceArea = glm::length(across);
  if (!(std::abs(glm::dot(across, face.normal)) > (1 - 1e-6) * twiceArea)) return;
  const Vec3 normal = across / twiceArea;
  for (std::size_t i = 0; i < face.points.size(); ++i)
    face.met[i] = face.met[i] || isWithin(face.points[i], a, b, c, normal);
}

}  // namespace

std::uint8_t coveredFaces(const World& world, const Opening& opening, const photometry::LuminaireFrame& frame,
                          const Vec3& center) {
  const bool box = opening.shape == Opening::Shape::box;
  if (!box && (opening.shape != Opening::Shape::cylinder || !emitter::isRound(opening))) return 0;
  const emitter::OpeningAxes named = emitter::axesOf(opening, frame);
  const std::array<Vec3, 3> axes{named.x, named.y, named.z};
  const Vec3 across = box ? Vec3(opening.length, opening.width, 0) : emitter::diametersOf(opening);
  const std::array<double, 3> half{0.5 * across.x, 0.5 * across.y, 0.5 * opening.height};

  std::vector<Face> faces;
  for (int index = box ? 0 : 4; index < 6; ++index) {
    const auto axis = static_cast<unsigned>(index / 2), u = (axis + 1) % 3, v = (axis + 2) % 3;
    Face face{index, index % 2 == 0 ? axes[axis] : -axes[axis], {}, 2 * nearness * std::min(half[u], half[v])};
    const Vec3 middle = center + face.normal * half[axis];
    face.points[0] = middle;
    for (std::size_t i = 0; i < 4; ++i)
      face.points[i + 1] =
          middle + axes[u] * (half[u] * (i % 2 == 0 ? 0.5 : -0.5)) + axes[v] * (half[v] * (i < 2 ? 0.5 : -0.5));
    faces.push_back(face);
  }
  for (std::size_t t = 0; t < world.triangles.size(); ++t) {
    if (world.surfaces[world.triangleSurfaces[t]].object == none) continue;  // another luminaire
    const auto& corner = world.triangles[t];
    for (Face& face : faces)
      lookAt(face, world.vertices[corner[0]], world.vertices[corner[1]], world.vertices[corner[2]]);
  }
  std::uint8_t covered = 0;
  bool allOfThem = true;
  for (const Face& face : faces) {
    const bool is = std::all_of(face.met.begin(), face.met.end(), [](bool met) { return met; });
    if (is) covered = static_cast<std::uint8_t>(covered | 1u << face.index);
    allOfThem = allOfThem && is;
  }
  return box && allOfThem ? 0 : covered;
}

}  // namespace goniolux::scene
