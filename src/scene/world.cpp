#include "scene/world.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <limits>

#include "geometry/bounds.h"
#include "geometry/quadric_intersect.h"
#include "geometry/queries.h"
#include "geometry/revolution.h"
#include "geometry/texture_coordinates.h"
#include "scene/covered_faces.h"
#include "scene/housing.h"

namespace goniolux::scene {
namespace {

using core::Mat4;
using core::Vec3;
using emitter::Opening;

constexpr std::size_t mostFlattened = 100'000;  // triangles

Vec3 transformed(const Mat4& m, const Vec3& p) {
  return Vec3(m * glm::dvec4(p, 1.0));
}

class Builder {
 public:
  explicit Builder(const Environment& environment) : environment_(environment), enclosures_(enclosuresOf(environment)) {
    world_.materials = environment.materials;
    world_.sourceSpectra = environment.sourceSpectra;
    world_.textures = environment.textures;
    world_.reliefs = environment.reliefs;
  }

  World build() {
    center();
    for (std::uint32_t i = 0; i < environment_.objects.size(); ++i) addObject(i);
    for (std::uint32_t i = 0; i < environment_.luminaires.size(); ++i) addLuminaire(i);
    return std::move(world_);
  }

 private:
  // The box about everything, luminaires included.
  void center() {
    constexpr double huge = std::numeric_limits<double>::max();
    Vec3 low(huge), high(-huge);
    const auto include = [&](const Vec3& p) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    };
    for (const Object& object : environment_.objects) {
      const geometry::Bounds bounds = geometry::bounds(object.shape, object.transform);
      if (bounds.empty()) continue;
      include(bounds.min);
      include(bounds.max);
      // Copies by the corners of the object's own box: cheap for thousands, and never too small.
      const geometry::Bounds own = object.copies.empty() ? geometry::Bounds{} : geometry::bounds(object.shape);
      for (const Mat4& place : object.copies) {
        for (int k = 0; k < 8; ++k)
          include(transformed(
              place, {k & 1 ? own.max.x : own.min.x, k & 2 ? own.max.y : own.min.y, k & 4 ? own.max.z : own.min.z}));
      }
    }
    for (const Luminaire& luminaire : environment_.luminaires) include(luminaire.center);
    if (low.x > high.x) return;
    world_.origin = 0.5 * (low + high);
    world_.radius = std::max(0.5 * glm::length(high - low), 1e-6);
  }

  std::uint32_t addSurface(Surface surface) {
    world_.surfaces.push_back(surface);
    return static_cast<std::uint32_t>(world_.surfaces.size() - 1);
  }

  bool addTriangle(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t surface) {
    if (glm::length(glm::cross(b - a, c - a)) == 0) return false;  // no area: neither seen nor lit
    const auto first = static_cast<std::uint32_t>(world_.vertices.size());
    world_.vertices.insert(world_.vertices.end(), {a, b, c});
    world_.triangles.push_back({first, first + 1, first + 2});
    world_.triangleSurfaces.push_back(surface);
    return true;
  }

  static Corners cornersOf(const geometry::Mesh& mesh, const geometry::Bounds& box, std::size_t triangle) {
    Corners corners;
    const auto coordinates = geometry::cornerCoordinates(mesh, box, triangle);
    for (std::size_t k = 0; k < 3; ++k) corners.coordinates[k] = glm::vec2(coordinates[k]);
    if (!mesh.smoothNormals.empty()) corners.normals = mesh.smoothNormals[triangle];
    return corners;
  }

  // Of the triangle that was added last.
  void addCorners(const Corners& corners) {
    world_.triangleCorners.resize(world_.triangles.size(), none);
    world_.triangleCorners.back() = static_cast<std::uint32_t>(world_.corners.size());
    world_.corners.push_back(corners);
  }

  void addPatch(geometry::QuadricPatch patch, const Mat4& toWorld, std::uint32_t surface) {
    patch.placement = toWorld * patch.placement;
    const Mat4 inverse = glm::inverse(patch.placement);
    world_.patches.push_back({patch, inverse, surface});
  }

  std::uint32_t sourceSpectrum(const spectrum::SpectralDistribution& spectrum) {
    const auto found = std::find(world_.sourceSpectra.begin(), world_.sourceSpectra.end(), spectrum);
    if (found != world_.sourceSpectra.end()) return static_cast<std::uint32_t>(found - world_.sourceSpectra.begin());
    world_.sourceSpectra.push_back(spectrum);
    return static_cast<std::uint32_t>(world_.sourceSpectra.size() - 1);
  }

  void addObject(std::uint32_t index) {
    const Object& object = environment_.objects[index];
    std::vector<std::uint32_t> partSurface;
    bool isDetailed = false;
    for (const std::uint32_t material : object.materials) {
      Surface surface;
      surface.material = material;
      surface.object = index;
      const material::Material& finish = environment_.materials[material];
      surface.isDetailed = finish.texture || finish.relief || !object.shape.mesh.smoothNormals.empty();
      isDetailed = isDetailed || surface.isDetailed;
      if (const auto& emission = environment_.materials[material].emission; emission && emission->exitance_lm_m2 > 0) {
        surface.luminance = emission->exitance_lm_m2 / core::pi;
        surface.spectrum = sourceSpectrum(emission->spectrum);
      }
      partSurface.push_back(addSurface(surface));
    }
    world_.chordError = std::max(world_.chordError, object.shape.chordError);
    if (isInstanced(object)) return addInstanced(object, partSurface);
    bool isFirst = true;
    for (Mat4 toWorld : placesOf(object)) {
      toWorld[3] -= glm::dvec4(world_.origin, 0.0);
      // A place of its own is a surface of its own where textures ask for the way back to the object.
      if (isDetailed && !isFirst)
        for (std::uint32_t& surface : partSurface) surface = addSurface(Surface(world_.surfaces[surface]));
      if (isDetailed) {
        for (const std::uint32_t surface : partSurface)
          world_.surfaces[surface].frame = static_cast<std::uint32_t>(world_.frames.size());
        world_.frames.push_back(glm::inverse(toWorld));
      }
      isFirst = false;
      addAt(object, toWorld, partSurface);
    }
  }

  bool isInstanced(const Object& object) const {
    const bool emits = std::any_of(object.materials.begin(), object.materials.end(), [&](std::uint32_t material) {
      const auto& emission = environment_.materials[material].emission;
      return emission && emission->exitance_lm_m2 > 0;
    });
    return !emits && !object.copies.empty() && object.shape.patches.empty() &&
           object.shape.mesh.triangles.size() * (object.copies.size() + 1) > mostFlattened;
  }

  void addInstanced(const Object& object, const std::vector<std::uint32_t>& partSurface) {
    const auto& mesh = object.shape.mesh;
    const Vec3 middle = geometry::bounds(object.shape).center();
    InstancedMesh instanced;
    instanced.middle = middle;
    const geometry::Bounds box = geometry::bounds(object.shape);
    const bool isDetailed = std::any_of(partSurface.begin(), partSurface.end(),
                                        [&](std::uint32_t surface) { return world_.surfaces[surface].isDetailed; });
    for (const Vec3& v : mesh.vertices) instanced.vertices.push_back(v - middle);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& corner = mesh.triangles[t];
      const Vec3 &a = mesh.vertices[corner[0]], &b = mesh.vertices[corner[1]], &c = mesh.vertices[corner[2]];
      if (glm::length(glm::cross(b - a, c - a)) == 0) continue;
      instanced.triangles.push_back(corner);
      instanced.triangleSurfaces.push_back(partSurface[mesh.parts[t]]);
      if (isDetailed) instanced.corners.push_back(cornersOf(mesh, box, t));
    }
    for (Mat4 place : placesOf(object)) {
      place[3] += glm::dvec4(core::Mat3(place) * middle - world_.origin, 0.0);
      instanced.places.push_back(place);
    }
    world_.instanced.push_back(std::move(instanced));
  }

  void addAt(const Object& object, const Mat4& toWorld, const std::vector<std::uint32_t>& partSurface) {
    const auto& mesh = object.shape.mesh;
    const geometry::Bounds box = geometry::bounds(object.shape);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& corner = mesh.triangles[t];
      const Vec3 a = transformed(toWorld, mesh.vertices[corner[0]]), b = transformed(toWorld, mesh.vertices[corner[1]]),
                 c = transformed(toWorld, mesh.vertices[corner[2]]);
      const std::uint32_t surface = partSurface[mesh.parts[t]];
      if (addTriangle(a, b, c, surface) && world_.surfaces[surface].isDetailed) addCorners(cornersOf(mesh, box, t));
      const Surface& finish = world_.surfaces[surface];
      if (finish.luminance > 0 && glm::length(glm::cross(b - a, c - a)) > 0) {
        geometry::Bounds bounds;
        bounds.add(a), bounds.add(b), bounds.add(c);
        world_.emitters.push_back({emitter::makeTriangleEmitter(a, b, c, finish.luminance * core::pi),
                                   finish.spectrum,
                                   none,
                                   true,
                                   bounds,
                                   {}});
      }
    }
    for (const auto& patch : object.shape.patches) addPatch(patch, toWorld, partSurface[patch.part]);
  }

  // True when a flat opening lies in a surface of the environment (within 1e-6 of the world's size).
  bool liesOnSurface(const Vec3& center, const Vec3& axis) const {
    const double tolerance = 1e-6 * 2 * world_.radius;
    for (std::size_t t = 0; t < world_.triangles.size(); ++t) {
      if (world_.surfaces[world_.triangleSurfaces[t]].object == none) continue;
      const Vec3 &a = world_.vertices[world_.triangles[t][0]], &b = world_.vertices[world_.triangles[t][1]],
                 &c = world_.vertices[world_.triangles[t][2]];
      const Vec3 normal = glm::normalize(glm::cross(b - a, c - a));
      if (std::abs(glm::dot(normal, axis)) < 1 - 1e-9 || std::abs(glm::dot(center - a, normal)) > tolerance) continue;
      // inside the triangle?
      const double s = glm::dot(glm::cross(b - a, center - a), normal),
                   u = glm::dot(glm::cross(c - b, center - b), normal),
                   v = glm::dot(glm::cross(a - c, center - c), normal);
      if (s >= 0 && u >= 0 && v >= 0) return true;
    }
    return false;
  }

  std::uint32_t openingMaterial(const Luminaire& luminaire) {
    material::Material material;
    material.name = luminaire.type + " (opening)";
    material.model = "lambert";
    material.spectra["diffuse"] = spectrum::SpectralDistribution::flat(luminaire.reflectance);
    for (std::size_t i = environment_.materials.size(); i < world_.materials.size(); ++i)
      if (world_.materials[i].name == material.name) return static_cast<std::uint32_t>(i);
    world_.materials.push_back(material);
    return static_cast<std::uint32_t>(world_.materials.size() - 1);
  }

  void addLuminaire(std::uint32_t index) {
    const Luminaire& luminaire = environment_.luminaires[index];
    Vec3 center = luminaire.center - world_.origin;
    Opening opening = luminaire.opening;
    opening.covered = coveredFaces(world_, opening, luminaire.frame, center);
    const bool flat = opening.shape == Opening::Shape::rectangle || opening.shape == Opening::Shape::disc;
    if (const Vec3 normal = emitter::axesOf(opening, luminaire.frame).z; flat && liesOnSurface(center, normal))
      center += (opening.along == Opening::Along::aim ? normal : luminaire.frame.aim) * (4e-6 * world_.radius);

    const double factor = luminaire.maintenance * luminaire.dimming;
    emitter::Output output;
    output.distribution = luminaire.distribution;
    output.frame = luminaire.frame;
    output.scale = luminaire.scale * factor;
    output.flux_lm = luminaire.flux_lm * factor;

    std::uint32_t source = none;
    auto made = emitter::makeEmitter(opening, center, output);
    const bool lit = made->flux() > 0;
    const bool hasGeometry = opening.shape != Opening::Shape::point && opening.shape != Opening::Shape::line;
    if (lit) {
      world_.emitters.push_back({std::move(made), luminaire.spectrum, index, hasGeometry, {}, {}});
      for (const Enclosure& enclosure : enclosures_)
        if (enclosure.luminaire == index && enclosure.isHousing)
          world_.emitters.back().housings.push_back(enclosure.object);
      source = static_cast<std::uint32_t>(world_.emitters.size() - 1);
    }
    if (lit && !hasGeometry) {
      const Vec3 half = opening.shape == Opening::Shape::line ? opening.axis * (0.5 * opening.length) : Vec3(0);
      world_.emitters[source].bounds.add(center - half);
      world_.emitters[source].bounds.add(center + half);
    }
    if (!hasGeometry) return;
    Surface surface;
    surface.material = openingMaterial(luminaire);
    surface.emitter = source;
    const std::size_t firstTriangle = world_.triangles.size(), firstPatch = world_.patches.size();
    addOpeningGeometry(opening, luminaire.frame, center, addSurface(surface));
    if (!lit) return;
    geometry::Bounds& bounds = world_.emitters[source].bounds;
    for (std::size_t t = firstTriangle; t < world_.triangles.size(); ++t)
      for (const std::uint32_t corner : world_.triangles[t]) bounds.add(world_.vertices[corner]);
    for (std::size_t p = firstPatch; p < world_.patches.size(); ++p)
      bounds.add(geometry::boundsOf(world_.patches[p].patch));
  }

  void addOpeningGeometry(const Opening& opening, const photometry::LuminaireFrame& frame, const Vec3& center,
                          std::uint32_t surface) {
    const auto placed = [&](const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& base) {
      return Mat4(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(base, 1));
    };
    const auto add = [&](geometry::QuadricPatch::Kind kind, const Mat4& placement) {
      geometry::QuadricPatch patch;
      patch.kind = kind;
      addPatch(patch, placement, surface);
    };
    const auto quad = [&](const Vec3& middle, const Vec3& u, const Vec3& v) {
      addTriangle(middle - u - v, middle + u - v, middle + u + v, surface);
      addTriangle(middle - u - v, middle + u + v, middle - u + v, surface);
    };
    using Kind = geometry::QuadricPatch::Kind;
    const emitter::OpeningAxes axes = emitter::axesOf(opening, frame);
    const Vec3 radii = 0.5 * emitter::diametersOf(opening);
    // The axes are left-handed as the luminaire frame is; placements with x and y exchanged are right-handed.
    const Vec3 rx = axes.x * radii.x, ry = axes.y * radii.y;
    // Windings and patch axes are chosen so that the geometric normal is the side of the aim, or outward.
    switch (opening.shape) {
      case Opening::Shape::rectangle: {
        const Vec3 u = axes.x * (0.5 * opening.length), v = axes.y * (0.5 * opening.width);
        glm::dot(glm::cross(u, v), axes.z) > 0 ? quad(center, u, v) : quad(center, v, u);
        break;
      }
      case Opening::Shape::disc:
        add(Kind::disc, placed(ry, rx, axes.z * radii.x, center));
        break;
      case Opening::Shape::box: {
        const Vec3 half[3] = {axes.x * (0.5 * opening.length), axes.y * (0.5 * opening.width),
                              axes.z * (0.5 * opening.height)};
        for (int i = 0; i < 3; ++i)
          for (const double side : {-1.0, 1.0}) {
            const Vec3 u = half[(i + 1) % 3], v = half[(i + 2) % 3], out = half[i] * side;
            glm::dot(glm::cross(u, v), out) > 0 ? quad(center + out, u, v) : quad(center + out, v, u);
          }
        break;
      }
      case Opening::Shape::sphere:
        add(Kind::sphere, placed(ry, rx, axes.z * radii.z, center));
        break;
      case Opening::Shape::cylinder: {
        const Vec3 half = axes.z * (0.5 * opening.height);
        add(Kind::cylinder, placed(ry, rx, 2.0 * half, center - half));
        add(Kind::disc, placed(rx, ry, -axes.z * radii.x, center - half));
        add(Kind::disc, placed(ry, rx, axes.z * radii.x, center + half));
        break;
      }
      case Opening::Shape::tube: {
        const Vec3 axis = glm::normalize(opening.axis);
        const double length = opening.length, radius = radii.x;
        Vec3 x, y;
        core::perpendiculars(axis, x, y);
        const Vec3 base = center - axis * (0.5 * length), top = center + axis * (0.5 * length);
        add(Kind::cylinder, placed(x * radius, y * radius, axis * length, base));
        Surface end = world_.surfaces[surface];  // a tube's ends are dark, but light does not pass through them
        end.emitter = none;
        surface = addSurface(end);
        add(Kind::disc, placed(y * radius, x * radius, -axis * radius, base));
        add(Kind::disc, placed(x * radius, y * radius, axis * radius, top));
        break;
      }
      case Opening::Shape::revolution:
        for (const geometry::QuadricPatch& patch : geometry::makeRevolution(opening.profile, center, frame.aim).patches)
          addPatch(patch, Mat4(1.0), surface);
        break;
      case Opening::Shape::point:
      case Opening::Shape::line:
        break;
    }
  }

  const Environment& environment_;
  std::vector<Enclosure> enclosures_;
  World world_;
};

}  // namespace

std::vector<geometry::Bounds> instanceBounds(const World& world) {
  std::vector<geometry::Bounds> boxes;
  for (const InstancedMesh& mesh : world.instanced) {
    geometry::Bounds own;
    for (const Vec3& v : mesh.vertices) own.add(v);
    for (const Mat4& place : mesh.places) {
      geometry::Bounds& box = boxes.emplace_back();
      for (int k = 0; k < 8; ++k)
        box.add(transformed(
            place, {k & 1 ? own.max.x : own.min.x, k & 2 ? own.max.y : own.min.y, k & 4 ? own.max.z : own.min.z}));
    }
  }
  return boxes;
}

World buildWorld(const Environment& environment) {
  return Builder(environment).build();
}

}  // namespace goniolux::scene
