#include "geometry/tessellate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/clipped_quadric.h"
#include "geometry/mesh_checks.h"
#include "geometry/quadric_intersect.h"

namespace goniolux::geometry {

using core::Vec2;
using core::Vec3;
using Kind = QuadricPatch::Kind;

namespace {

// Circles of a round patch as (radius, height), from which strips are made.
std::vector<Vec2> ringsOf(const QuadricPatch& patch, int sides) {
  std::vector<Vec2> rings;
  switch (patch.kind) {
    case Kind::disc:
      return {{1, 0}, {patch.ratio, 0}};
    case Kind::cylinder:
      return {{1, 0}, {1, 1}};
    case Kind::cone:
      return {{1, 0}, {patch.ratio, 1}};
    case Kind::sphere:
      for (int i = 0; 2 * i <= sides; ++i) {
        const double angle = core::pi * i / (sides / 2);
        rings.emplace_back(2 * i == sides || i == 0 ? 0.0 : std::sin(angle), -std::cos(angle));
      }
      break;
    case Kind::torus:
      for (int i = 0; i <= sides; ++i) {
        const double angle = 2 * core::pi * (i % sides) / sides;
        rings.emplace_back(1 + patch.ratio * std::cos(angle), patch.ratio * std::sin(angle));
      }
      break;
    case Kind::quadric:
      break;
  }
  return rings;
}

// Canonical triangles, counter-clockwise about the canonical front (before `turned`).
void addStrips(const std::vector<Vec2>& rings, int sides, Mesh& mesh) {
  const auto count = static_cast<std::uint32_t>(sides);
  for (const Vec2& ring : rings) {
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * core::pi * i / sides;
      mesh.vertices.emplace_back(ring.x * std::cos(angle), ring.x * std::sin(angle), ring.y);
    }
  }
  for (std::uint32_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t a = r * count + i, b = r * count + (i + 1) % count, c = b + count, d = a + count;
      if (rings[r].x > 0) mesh.triangles.push_back({a, b, c});
      if (rings[r + 1].x > 0) mesh.triangles.push_back({a, c, d});
    }
  }
}

// Marching tetrahedra over the cube: six about each cell's diagonal. — Doi & Koide, IEICE Trans. E74 (1991)
class Marching {
 public:
  Marching(const core::Mat4& form, int cells, Mesh& mesh) : form_(form), cells_(cells), mesh_(mesh) {}

  void run() {
    constexpr int paths[6][2] = {{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}};
    for (int x = 0; x < cells_; ++x)
      for (int y = 0; y < cells_; ++y)
        for (int z = 0; z < cells_; ++z)
          for (const auto& path : paths)
            tetrahedron({corner(x, y, z, 0), corner(x, y, z, path[0]), corner(x, y, z, path[1]), corner(x, y, z, 7)});
  }

 private:
  using Node = std::uint64_t;

  Node corner(int x, int y, int z, int bits) const {
    const auto side = static_cast<Node>(cells_ + 1);
    return (static_cast<Node>(x + (bits & 1)) * side + static_cast<Node>(y + (bits >> 1 & 1))) * side +
           static_cast<Node>(z + (bits >> 2 & 1));
  }
  Vec3 pointOf(Node node) const {
    const auto side = static_cast<Node>(cells_ + 1);
    const Vec3 index(double(node / side / side), double(node / side % side), double(node % side));
    return 2.0 / cells_ * index - Vec3(1);
  }
  // 0 counts as outside, so that no crossing is found twice.
  bool isInside(Node node) const { return quadricValue(form_, pointOf(node)) < 0; }

  std::uint32_t crossing(Node in, Node out) {
    const auto [found, isNew] =
        known_.try_emplace(std::minmax(in, out), static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (isNew) {
      // Along an edge the form is a quadratic with one root: bisection ends at the last bit.
      Vec3 low = pointOf(in), high = pointOf(out);
      for (int i = 0; i < 60; ++i) {
        const Vec3 middle = 0.5 * (low + high);
        (quadricValue(form_, middle) < 0 ? low : high) = middle;
      }
      mesh_.vertices.push_back(high);
    }
    return found->second;
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vec3 &p = mesh_.vertices[a], &q = mesh_.vertices[b], &r = mesh_.vertices[c];
    const Vec3 normal = glm::cross(q - p, r - p);
    if (glm::dot(normal, quadricHalfGradient(form_, (p + q + r) / 3.0)) < 0) std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  }

  void tetrahedron(const std::array<Node, 4>& nodes) {
    std::array<Node, 4> in{}, out{};
    std::size_t ins = 0, outs = 0;
    for (const Node node : nodes) isInside(node) ? in[ins++] = node : out[outs++] = node;
    if (ins == 1 || ins == 3) {
      const bool one = ins == 1;
      std::array<std::uint32_t, 3> v{};
      for (std::size_t k = 0; k < 3; ++k) v[k] = one ? crossing(in[0], out[k]) : crossing(in[k], out[0]);
      add(v[0], v[1], v[2]);
    } else if (ins == 2) {
      const std::uint32_t a = crossing(in[0], out[0]), b = crossing(in[0], out[1]), c = crossing(in[1], out[1]),
                          d = crossing(in[1], out[0]);
      add(a, b, c);
      add(a, c, d);
    }
  }

  const core::Mat4& form_;
  int cells_;
  Mesh& mesh_;
  std::map<std::pair<Node, Node>, std::uint32_t> known_;
};

}  // namespace

Mesh tessellate(const QuadricPatch& patch, int sides) {
  Mesh mesh;
  if (patch.kind == Kind::quadric) {
    Marching(patch.form, sides, mesh).run();
  } else {
    addStrips(ringsOf(patch, patch.kind == Kind::sphere ? sides + sides % 2 : sides), sides, mesh);
  }
  // A placement that mirrors turns triangles, but not fronts.
  if (patch.turned != (glm::determinant(core::Mat3(patch.placement)) < 0)) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  for (Vec3& v : mesh.vertices) v = Vec3(patch.placement * glm::dvec4(v, 1));
  mesh.parts.assign(mesh.triangles.size(), patch.part);
  if (patch.kind == Kind::quadric) {  // where the surface runs through a node of the cells, several crossings are one
    mergeVertices(mesh, 1e-12 * glm::length(boundsOf(mesh).extent()));
    removeCollapsedTriangles(mesh);
  }
  return mesh;
}

Mesh tessellate(const Shape& shape, int sides) {
  Mesh whole = shape.mesh;
  for (const QuadricPatch& patch : shape.patches) {
    const Mesh piece = tessellate(patch, sides);
    const auto first = static_cast<std::uint32_t>(whole.vertices.size());
    whole.vertices.insert(whole.vertices.end(), piece.vertices.begin(), piece.vertices.end());
    for (const auto& t : piece.triangles) whole.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    whole.parts.insert(whole.parts.end(), piece.parts.begin(), piece.parts.end());
  }
  return whole;
}

}  // namespace goniolux::geometry
