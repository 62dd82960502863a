#include "pipeline/feature_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/tessellate.h"

namespace goniolux::pipeline {
namespace {

using core::Mat4;
using core::Vec3;
using geometry::Mesh;
using geometry::QuadricPatch;

constexpr double bendCosine = 0.93969262078590838;  // cos 20 degrees
constexpr std::size_t largestNumberOfEdges = 20000;
constexpr int roundSides = 48;

Vec3 transformed(const Mat4& matrix, const Vec3& point) {
  return {matrix * glm::dvec4(point, 1.0)};
}

// ---- triangles ----

/// One index per distinct position: meshes often repeat their vertices for each face.
std::vector<std::uint32_t> weld(const std::vector<Vec3>& vertices) {
  Vec3 low(0), high(0);
  for (const Vec3& v : vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  const double cell = std::max(glm::length(high - low), 1e-30) * 1e-7;
  std::map<std::array<long long, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> index;
  index.reserve(vertices.size());
  for (const Vec3& v : vertices) {
    const std::array<long long, 3> key{std::llround(v.x / cell), std::llround(v.y / cell), std::llround(v.z / cell)};
    index.push_back(first.try_emplace(key, static_cast<std::uint32_t>(index.size())).first->second);
  }
  return index;
}

struct EdgeUse {
  int count = 0;
  Vec3 normal{0};       // of the first triangle
  bool forward = true;  // direction in which the first triangle runs along it
  bool bends = false, turnsAway = false;
};

void meshEdges(const Mesh& mesh, const Mat4& toWorld, std::vector<Segment>& edges) {
  std::vector<Vec3> world;
  world.reserve(mesh.vertices.size());
  for (const Vec3& v : mesh.vertices) world.push_back(transformed(toWorld, v));
  const std::vector<std::uint32_t> index = weld(world);

  std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse> uses;
  for (const auto& triangle : mesh.triangles) {
    const std::array<std::uint32_t, 3> corner{index[triangle[0]], index[triangle[1]], index[triangle[2]]};
    const Vec3 cross = glm::cross(world[corner[1]] - world[corner[0]], world[corner[2]] - world[corner[0]]);
    const double area2 = glm::length(cross);
    if (!(area2 > 0)) continue;
    const Vec3 normal = cross / area2;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = corner[i], b = corner[(i + 1) % 3];
      EdgeUse& use = uses[std::minmax(a, b)];
      if (++use.count == 1) {
        use.normal = normal;
        use.forward = a < b;
        continue;
      }
      // Neighbours that are wound alike run along their common edge in opposite directions.
      const Vec3 same = use.forward == (a < b) ? -normal : normal;
      use.bends = use.bends || glm::dot(same, use.normal) < bendCosine;
      use.turnsAway = use.turnsAway || (same.z > 1e-9) != (use.normal.z > 1e-9);
    }
  }
  for (const auto& [ends, use] : uses) {
    if (use.count != 2 || use.bends || use.turnsAway) edges.push_back({world[ends.first], world[ends.second]});
  }
}

// ---- quadric patches ----

Vec3 onCircle(double angle, double radius, double z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

void circle(const Mat4& toWorld, double radius, double z, std::vector<Segment>& edges) {
  if (!(radius > 0)) return;
  for (int i = 0; i < roundSides; ++i) {
    const double a = 2 * core::pi * i / roundSides, b = 2 * core::pi * (i + 1) / roundSides;
    edges.push_back({transformed(toWorld, onCircle(a, radius, z)), transformed(toWorld, onCircle(b, radius, z))});
  }
}

/// The canonical direction d with d.n = 0 exactly where the world normal of canonical normal n is horizontal:
/// world normal = M^-T n, its z = n . (M^-1 e_z).
Vec3 canonicalUp(const Mat4& toWorld) {
  return glm::inverse(core::Mat3(toWorld)) * Vec3(0, 0, 1);
}

void sphereSilhouette(const Mat4& toWorld, std::vector<Segment>& edges) {
  Vec3 x, y;
  core::perpendiculars(glm::normalize(canonicalUp(toWorld)), x, y);
  for (int i = 0; i < roundSides; ++i) {
    const double a = 2 * core::pi * i / roundSides, b = 2 * core::pi * (i + 1) / roundSides;
    edges.push_back({transformed(toWorld, x * std::cos(a) + y * std::sin(a)),
                     transformed(toWorld, x * std::cos(b) + y * std::sin(b))});
  }
}

/// Cylinder (ratio 1) and cone: the generators at which the normal (cos a, sin a, 1 - ratio) turns horizontal in the
/// world.
void sideSilhouette(const Mat4& toWorld, double ratio, std::vector<Segment>& edges) {
  const Vec3 up = canonicalUp(toWorld);
  const double across = std::hypot(up.x, up.y), along = (1 - ratio) * up.z;
  if (!(across > 1e-12 * std::abs(up.z)) || std::abs(along) > across) return;
  const double middle = std::atan2(up.y, up.x), half = std::acos(-along / across);
  for (const double angle : {middle - half, middle + half}) {
    edges.push_back({transformed(toWorld, onCircle(angle, 1, 0)), transformed(toWorld, onCircle(angle, ratio, 1))});
  }
}

void patchEdges(const QuadricPatch& patch, const Mat4& objectToWorld, std::vector<Segment>& edges) {
  const Mat4 toWorld = objectToWorld * patch.placement;
  if (!(std::abs(glm::determinant(core::Mat3(toWorld))) > 0)) return;
  const double ratio = patch.kind == QuadricPatch::Kind::cone ? patch.ratio : 1;
  const bool hasRims = !patch.isFacet;
  switch (patch.kind) {
    case QuadricPatch::Kind::disc:
      if (hasRims) circle(toWorld, 1, 0, edges);
      if (hasRims) circle(toWorld, patch.ratio, 0, edges);
      break;
    case QuadricPatch::Kind::sphere:
      sphereSilhouette(toWorld, edges);
      break;
    case QuadricPatch::Kind::cylinder:
    case QuadricPatch::Kind::cone:
      if (hasRims) circle(toWorld, 1, 0, edges);
      if (hasRims) circle(toWorld, ratio, 1, edges);
      sideSilhouette(toWorld, ratio, edges);
      break;
    case QuadricPatch::Kind::torus:
    case QuadricPatch::Kind::quadric:
      meshEdges(geometry::tessellate(patch, roundSides), objectToWorld, edges);
      break;
  }
}

}  // namespace

std::vector<Segment> featureEdges(const scene::Object& object) {
  std::vector<Segment> edges;
  meshEdges(object.shape.mesh, object.transform, edges);
  for (const QuadricPatch& patch : object.shape.patches) patchEdges(patch, object.transform, edges);
  if (edges.size() > largestNumberOfEdges) {
    const auto longer = [](const Segment& a, const Segment& b) {
      return glm::distance(a.from, a.to) > glm::distance(b.from, b.to);
    };
    std::stable_sort(edges.begin(), edges.end(), longer);
    edges.resize(largestNumberOfEdges);
  }
  return edges;
}

std::vector<Triangle> coveringTriangles(const scene::Object& object) {
  std::vector<Triangle> triangles;
  const Mesh mesh = geometry::tessellate(object.shape, roundSides);
  for (const auto& corner : mesh.triangles) {
    triangles.push_back({transformed(object.transform, mesh.vertices[corner[0]]),
                         transformed(object.transform, mesh.vertices[corner[1]]),
                         transformed(object.transform, mesh.vertices[corner[2]])});
  }
  return triangles;
}

}  // namespace goniolux::pipeline
