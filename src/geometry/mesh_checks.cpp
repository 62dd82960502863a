#include "geometry/mesh_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace goniolux::geometry {

using core::Vec3;

namespace {

using EdgeKey = std::uint64_t;

EdgeKey keyOf(std::uint32_t a, std::uint32_t b) {
  return (EdgeKey(std::min(a, b)) << 32) | std::max(a, b);
}

// One use of an edge by a triangle; `forward`: from the lower to the higher vertex number.
struct Use {
  EdgeKey edge;
  std::uint32_t triangle;
  bool forward;
};

// All uses, those of an edge side by side.
std::vector<Use> usesOfEdges(const Mesh& mesh) {
  std::vector<Use> uses;
  uses.reserve(mesh.triangles.size() * 3);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      uses.push_back({keyOf(a, b), i, a < b});
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const Use& a, const Use& b) { return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle; });
  return uses;
}

void flip(Mesh& mesh, std::size_t i) {
  std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
  if (!mesh.coordinates.empty()) std::swap(mesh.coordinates[i][1], mesh.coordinates[i][2]);
}

struct CellHash {
  std::size_t operator()(const std::array<std::int64_t, 3>& cell) const {
    std::uint64_t h = 0;
    for (const std::int64_t c : cell) h = (h ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15ULL + (h >> 29);
    return static_cast<std::size_t>(h);
  }
};

template <typename Condition>
std::size_t removeIf(Mesh& mesh, const Condition& condition) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (condition(mesh.triangles[i])) continue;
    mesh.triangles[kept] = mesh.triangles[i];
    mesh.parts[kept] = mesh.parts[i];
    if (!mesh.coordinates.empty()) mesh.coordinates[kept] = mesh.coordinates[i];
    ++kept;
  }
  const std::size_t dropped = mesh.triangles.size() - kept;
  mesh.triangles.resize(kept);
  mesh.parts.resize(kept);
  if (!mesh.coordinates.empty()) mesh.coordinates.resize(kept);
  return dropped;
}

}  // namespace

bool isDegenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, w = c - b;
  const double longest = std::max({glm::dot(u, u), glm::dot(v, v), glm::dot(w, w)});
  return !(glm::length(glm::cross(u, v)) > 1e-10 * longest);
}

std::size_t removeCollapsedTriangles(Mesh& mesh) {
  return removeIf(mesh, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

std::size_t removeDegenerateTriangles(Mesh& mesh) {
  return removeIf(
      mesh, [&](const auto& t) { return isDegenerate(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]); });
}

void mergeVertices(Mesh& mesh, double tolerance) {
  // A vertex joins the first one found within the tolerance. Cells are two tolerances wide, so that only the eight
  // about the nearest corner of its cell can hold one; those kept in a cell are chained.
  constexpr std::uint32_t none = UINT32_MAX;
  std::unordered_map<std::array<std::int64_t, 3>, std::uint32_t, CellHash> cells;
  cells.reserve(mesh.vertices.size());
  std::vector<std::uint32_t> renamed(mesh.vertices.size()), next;
  std::vector<Vec3> kept;
  const double pitch = 2 * std::max(tolerance, 1e-300);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& p = mesh.vertices[i];
    std::array<std::int64_t, 3> cell, low;
    for (int axis = 0; axis < 3; ++axis) {
      const double at = p[axis] / pitch;
      cell[std::size_t(axis)] = static_cast<std::int64_t>(std::floor(at));
      low[std::size_t(axis)] = std::llround(at) - 1;
    }
    std::uint32_t found = none;
    for (unsigned n = 0; n < 8 && found == none; ++n) {
      const auto it = cells.find({low[0] + (n & 1), low[1] + (n >> 1 & 1), low[2] + (n >> 2)});
      if (it == cells.end()) continue;
      for (found = it->second; found != none && !(glm::distance(kept[found], p) <= tolerance);) found = next[found];
    }
    if (found == none) {
      found = static_cast<std::uint32_t>(kept.size());
      kept.push_back(p);
      const auto [head, isNew] = cells.try_emplace(cell, found);
      next.push_back(isNew ? none : std::exchange(head->second, found));
    }
    renamed[i] = found;
  }
  for (auto& t : mesh.triangles) {
    for (auto& vertex : t) vertex = renamed[vertex];
  }
  mesh.vertices = std::move(kept);
}

EdgeReport checkEdges(const Mesh& mesh) {
  EdgeReport report;
  const std::vector<Use> uses = usesOfEdges(mesh);
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].edge == uses[first].edge) ++last;
    ++report.edges;
    if (last - first == 1) {
      ++report.boundary;
    } else if (last - first > 2) {
      ++report.nonManifold;
    } else if (uses[first].forward == uses[first + 1].forward) {
      ++report.inconsistent;
    }
  }
  return report;
}

EdgeReport orientOutward(Mesh& mesh) {
  EdgeReport report = checkEdges(mesh);
  if (report.inconsistent > 0) {
    const auto uses = usesOfEdges(mesh);
    enum : std::uint8_t { untouched, kept, turned };
    std::vector<std::uint8_t> state(mesh.triangles.size(), untouched);
    std::vector<std::uint32_t> shell;
    for (std::uint32_t seed = 0; seed < state.size(); ++seed) {
      if (state[seed] != untouched) continue;
      state[seed] = kept;
      shell.assign(1, seed);
      for (std::size_t next = 0; next < shell.size(); ++next) {
        const std::uint32_t i = shell[next];
        for (unsigned k = 0; k < 3; ++k) {
          const auto& t = mesh.triangles[i];  // as the file has it: turned ones are flipped when the shell is complete
          const EdgeKey edge = keyOf(t[k], t[(k + 1) % 3]);
          const auto begin =
              std::partition_point(uses.begin(), uses.end(), [&](const Use& u) { return u.edge < edge; });
          const auto end = std::partition_point(begin, uses.end(), [&](const Use& u) { return u.edge == edge; });
          if (end - begin != 2) continue;
          const Use& mine = begin->triangle == i ? begin[0] : begin[1];
          const Use& other = begin->triangle == i ? begin[1] : begin[0];
          if (state[other.triangle] != untouched) continue;
          const bool agrees = mine.forward != other.forward;
          state[other.triangle] = agrees == (state[i] == kept) ? kept : turned;
          shell.push_back(other.triangle);
        }
      }
      Mesh part;
      part.vertices = mesh.vertices;
      for (const std::uint32_t i : shell) {
        if (state[i] == turned) flip(mesh, i);
        part.triangles.push_back(mesh.triangles[i]);
      }
      if (signedVolume(part) < 0) {
        for (const std::uint32_t i : shell) flip(mesh, i);
      }
    }
    report = checkEdges(mesh);
  }
  if (report.watertight() && signedVolume(mesh) < 0) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) flip(mesh, i);
  }
  return report;
}

Bounds boundsOf(const Mesh& mesh) {
  Bounds box;
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t vertex : t) box.add(mesh.vertices[vertex]);
  }
  return box;
}

double signedVolume(const Mesh& mesh) {
  if (mesh.vertices.empty()) return 0;
  // Divergence theorem; from a vertex of the mesh, so that a solid far from the origin loses no digits.
  const Vec3 reference = mesh.vertices.front();
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    sum += glm::dot(mesh.vertices[t[0]] - reference,
                    glm::cross(mesh.vertices[t[1]] - reference, mesh.vertices[t[2]] - reference));
  }
  return sum / 6;
}

}  // namespace goniolux::geometry
