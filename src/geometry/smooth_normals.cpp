#include "geometry/smooth_normals.h"

#include <algorithm>
#include <cmath>

namespace goniolux::geometry {

using core::Vec3;
using core::Vec3f;

void addSmoothNormals(Mesh& mesh, double crease) {
  const std::size_t count = mesh.triangles.size();
  std::vector<Vec3> faces(count, Vec3(0));
  // The corners at each vertex, side by side.
  std::vector<std::uint32_t> first(mesh.vertices.size() + 1, 0), corners(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& t = mesh.triangles[i];
    const Vec3 normal =
        glm::cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    const double length = glm::length(normal);
    if (length > 0) faces[i] = normal / length;
    for (const std::uint32_t vertex : t) ++first[vertex + 1];
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) first[v + 1] += first[v];
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t i = 0; i < count; ++i)
    for (std::uint32_t k = 0; k < 3; ++k) corners[next[mesh.triangles[i][k]]++] = 3 * i + k;

  const auto angleAt = [&](std::uint32_t corner) {
    const auto& t = mesh.triangles[corner / 3];
    const Vec3 &p = mesh.vertices[t[corner % 3]], u = mesh.vertices[t[(corner + 1) % 3]] - p,
               v = mesh.vertices[t[(corner + 2) % 3]] - p;
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
  };
  const double least = std::cos(crease);
  mesh.smoothNormals.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[i][k];
      Vec3 sum(0);
      for (std::uint32_t c = first[vertex]; c < first[vertex + 1]; ++c) {
        const Vec3& face = faces[corners[c] / 3];
        if (glm::dot(face, faces[i]) >= least) sum += angleAt(corners[c]) * face;
      }
      const double length = glm::length(sum);
      mesh.smoothNormals[i][k] = Vec3f(length > 0 ? sum / length : faces[i]);
    }
  }
}

}  // namespace goniolux::geometry
