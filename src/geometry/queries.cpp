#include "geometry/queries.h"

#include <cmath>

#include "geometry/clipped_quadric.h"
#include "geometry/quadric_intersect.h"
#include "geometry/surface_points.h"

namespace goniolux::geometry {

using core::Mat3;
using core::Mat4;
using core::Vec3;
using Kind = QuadricPatch::Kind;

namespace {

Vec3 apply(const Mat4& map, const Vec3& point) {
  return Vec3(map * glm::dvec4(point, 1));
}

constexpr int quadricSteps = 256;

// Mean of |C n(phi)| over the circle n = (rho cos phi, rho sin phi, z): the trapezoidal rule, which converges
// geometrically for periodic functions.
double meanLength(const Mat3& c, double rho, double z) {
  constexpr int steps = 256;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double phi = 2 * core::pi * (i + 0.5) / steps;
    sum += glm::length(c * Vec3(rho * std::cos(phi), rho * std::sin(phi), z));
  }
  return sum / steps;
}

// Area of the mapped patch = integral over the canonical patch of |cof(M) n| dA.
double patchArea(const QuadricPatch& patch, const Mat4& transform) {
  const Mat3 c = cofactor(Mat3(transform * patch.placement));
  switch (patch.kind) {
    case Kind::disc:
      return core::pi * (1 - patch.ratio * patch.ratio) * glm::length(c[2]);
    case Kind::sphere: {
      // Archimedes: dA = dz dphi. Fejer's first rule over z, nodes cos(theta): converges geometrically, exact for
      // spheres.
      constexpr int nodes = 128;
      double sum = 0;
      for (int i = 0; i < nodes; ++i) {
        const double theta = core::pi * (i + 0.5) / nodes;
        double weight = 1;
        for (int k = 1; k <= nodes / 2; ++k) weight -= 2 * std::cos(2 * k * theta) / (4.0 * k * k - 1);
        sum += 2.0 / nodes * weight * meanLength(c, std::sin(theta), std::cos(theta));
      }
      return 2 * core::pi * sum;
    }
    case Kind::cylinder:
      return 2 * core::pi * meanLength(c, 1, 0);
    case Kind::torus: {
      // dA = k (1 + k cos theta) dtheta dphi; the trapezoidal rule round both circles.
      constexpr int nodes = 128;
      const double k = patch.ratio;
      double sum = 0;
      for (int i = 0; i < nodes; ++i) {
        const double theta = 2 * core::pi * (i + 0.5) / nodes;
        sum += (1 + k * std::cos(theta)) * meanLength(c, std::cos(theta), std::sin(theta));
      }
      return 4 * core::pi * core::pi * k * sum / nodes;
    }
    case Kind::quadric: {
      double sum = 0;
      visitSurface(patch.form, quadricSteps,
                   [&](const Vec3&, const Vec3& normal, double area) { sum += area * glm::length(c * normal); });
      return sum;
    }
    case Kind::cone:
      break;
  }
  // Side r(z) = 1 + s z: n dA = (cos phi, sin phi, -s) r dz dphi, and the mean of r is (1 + ratio) / 2.
  return core::pi * (1 + patch.ratio) * meanLength(c, 1, 1 - patch.ratio);
}

// Integrals of n and of p . n over the canonical patch.
struct Moments {
  Vec3 normal{0};
  double flux = 0;
};

Moments outwardMoments(const QuadricPatch& patch) {
  switch (patch.kind) {
    case Kind::disc:
      return {{0, 0, core::pi * (1 - patch.ratio * patch.ratio)}, 0};
    case Kind::sphere:
      return {Vec3(0), 4 * core::pi};
    case Kind::cylinder:
      return {Vec3(0), 2 * core::pi};
    case Kind::torus:
      return {Vec3(0), 6 * core::pi * core::pi * patch.ratio * patch.ratio};  // three times the volume
    case Kind::quadric: {
      Moments sum;
      visitSurface(patch.form, quadricSteps, [&](const Vec3& point, const Vec3& normal, double area) {
        sum.normal += area * normal;
        sum.flux += area * glm::dot(point, normal);
      });
      return sum;
    }
    case Kind::cone:
      break;
  }
  const double k = patch.ratio;
  return {{0, 0, core::pi * (1 - k * k)}, core::pi * (1 + k)};  // p . n dA = r dz dphi, as r - s z = 1
}

Moments momentsOf(const QuadricPatch& patch) {
  const Moments moments = outwardMoments(patch);
  return patch.turned ? Moments{-moments.normal, -moments.flux} : moments;
}

Vec3 areaVector(const Mesh& mesh, std::size_t triangle, const Mat4& transform) {
  const auto& t = mesh.triangles[triangle];
  const Vec3 a = apply(transform, mesh.vertices[t[0]]);
  return 0.5 * glm::cross(apply(transform, mesh.vertices[t[1]]) - a, apply(transform, mesh.vertices[t[2]]) - a);
}

}  // namespace

std::vector<double> partAreas(const Shape& shape, const Mat4& transform) {
  std::vector<double> areas(shape.partNames.size(), 0.0);
  for (std::size_t i = 0; i < shape.mesh.triangles.size(); ++i) {
    areas[shape.mesh.parts[i]] += glm::length(areaVector(shape.mesh, i, transform));
  }
  for (const QuadricPatch& patch : shape.patches) areas[patch.part] += patchArea(patch, transform);
  return areas;
}

double area(const Shape& shape, const Mat4& transform) {
  double sum = 0;
  for (const double part : partAreas(shape, transform)) sum += part;
  return sum;
}

Vec3 vectorArea(const Shape& shape, const Mat4& transform) {
  const double sign = glm::determinant(Mat3(transform)) < 0 ? -1 : 1;
  Vec3 sum(0);
  for (std::size_t i = 0; i < shape.mesh.triangles.size(); ++i) sum += sign * areaVector(shape.mesh, i, transform);
  for (const QuadricPatch& patch : shape.patches) {
    const Mat3 map(transform * patch.placement);
    // Outward stays outward under a reflection, while the cofactor matrix turns with it.
    sum += (glm::determinant(map) < 0 ? -1.0 : 1.0) * (cofactor(map) * momentsOf(patch).normal);
  }
  return sum;
}

double volume(const Shape& shape, const Mat4& transform) {
  const Bounds box = bounds(shape, transform);
  if (box.empty()) return 0;
  // Divergence theorem, V = 1/3 integral of x . n dA, from the middle of the shape to keep digits.
  const Vec3 middle = box.center();
  const double sign = glm::determinant(Mat3(transform)) < 0 ? -1 : 1;
  double sum = 0;
  for (std::size_t i = 0; i < shape.mesh.triangles.size(); ++i) {
    const Vec3 corner = apply(transform, shape.mesh.vertices[shape.mesh.triangles[i][0]]) - middle;
    sum += sign * glm::dot(corner, areaVector(shape.mesh, i, transform));
  }
  for (const QuadricPatch& patch : shape.patches) {
    const Mat4 map = transform * patch.placement;
    const Mat3 linear(map);
    const double determinant = glm::determinant(linear);
    const Moments moments = momentsOf(patch);
    const double flux = determinant * moments.flux + glm::dot(Vec3(map[3]) - middle, cofactor(linear) * moments.normal);
    sum += determinant < 0 ? -flux : flux;
  }
  return sum / 3;
}

Bounds bounds(const Shape& shape, const Mat4& transform) {
  Bounds box;
  for (const auto& t : shape.mesh.triangles) {
    for (const std::uint32_t vertex : t) box.add(apply(transform, shape.mesh.vertices[vertex]));
  }
  for (const QuadricPatch& patch : shape.patches) box.add(boundsOf(patch, transform));
  return box;
}

CoplanarFaces facesInPlane(const Shape& shape, const Mat4& transform, const Vec3& point, const Vec3& normal,
                           double tolerance) {
  CoplanarFaces faces;
  const auto offset = [&](const Vec3& p) { return std::abs(glm::dot(p - point, normal)); };
  for (std::uint32_t i = 0; i < shape.mesh.triangles.size(); ++i) {
    bool inPlane = true;
    for (const std::uint32_t vertex : shape.mesh.triangles[i]) {
      inPlane = inPlane && offset(apply(transform, shape.mesh.vertices[vertex])) <= tolerance;
    }
    if (inPlane) faces.triangles.push_back(i);
  }
  for (std::uint32_t i = 0; i < shape.patches.size(); ++i) {
    if (shape.patches[i].kind != Kind::disc) continue;
    const Mat4 map = transform * shape.patches[i].placement;
    // The rim's largest distance from its centre along the normal.
    const double tilt = std::hypot(glm::dot(Vec3(map[0]), normal), glm::dot(Vec3(map[1]), normal));
    if (offset(Vec3(map[3])) + tilt <= tolerance) faces.patches.push_back(i);
  }
  return faces;
}

}  // namespace goniolux::geometry
