// The scene as Radiance files. Radiance's formats: its reference manual (refer/ray.html) and file formats page.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/inside.h"
#include "geometry/tessellate.h"
#include "pipeline/flux_bands.h"
#include "pipeline/radiance_luminaire.h"
#include "pipeline/scene_export.h"
#include "project/results.h"
#include "scene/world.h"

namespace goniolux::pipeline {
namespace {

using core::Mat4;
using core::Vec3;
using Kind = geometry::QuadricPatch::Kind;
using Three = FluxBands::Three;

constexpr int facets = 96;       // of what Radiance has no primitive for
constexpr double lift = 1e-4;    // m, of a flat opening before the surface that it lies on
constexpr double largest = 5e6;  // triangles

std::string identifier(const std::string& prefix, const std::string& name, std::size_t number) {
  std::string text = prefix + std::to_string(number) + "_";
  for (const char c : name) text += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return text;
}

std::string text(const Three& v) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", v[0], v[1], v[2]);
}
std::string text(const Vec3& v) {
  return fmt::format("{:.10g} {:.10g} {:.10g}", v.x, v.y, v.z);
}
Three times(const Three& v, double factor) {
  return {v[0] * factor, v[1] * factor, v[2] * factor};
}

class Writer {
 public:
  Writer(const project::Project& project, core::Diagnostics& left)
      : project_(project),
        left_(left),
        world_(scene::buildWorld(project.environment)),
        bands_(project.environment.luminaires.empty()
                   ? spectrum::SpectralDistribution::flat(1)
                   : world_.sourceSpectra[project.environment.luminaires.front().spectrum]) {}

  FileContents write() {
    scene_ = fmt::format(
        "# {}: written by goniolux. Three channels are three bands of the lamp's spectrum; values are cd/m2, and an\n"
        "# illuminance in lx is the sum of the channels (rtrace -I). See calculate.sh.\n\n",
        project_.name);
    for (std::size_t i = 0; i < world_.materials.size(); ++i) material(i);
    for (std::size_t i = 0; i < project_.environment.luminaires.size(); ++i) luminaire(i);
    surfaces();
    grids();
    for (const scene::View& view : project_.views) viewFile(view);
    files_["scene.rad"] = scene_;
    files_["calculate.sh"] = script();
    return std::move(files_);
  }

 private:
  void warn(const core::SourcePosition& position, std::string message) {
    left_.warning(position, "radiance", std::move(message));
  }

  void material(std::size_t index) {
    const material::Material& m = world_.materials[index];
    materialNames_.push_back(identifier("m", m.name, index));
    if (m.texture) warn(m.position, fmt::format("the texture of \"{}\" is written as its mean", m.name));
    const auto curve = [&](const char* key) { return m.spectra.find(key); };
    if (const auto diffuse = curve("diffuse"); diffuse != m.spectra.end()) {
      if (m.model != "lambert")
        warn(m.position, fmt::format("\"{}\" ({}) is written as its diffuse part only", m.name, m.model));
      scene_ +=
          fmt::format("void plastic {} 0 0 5 {} 0 0\n", materialNames_.back(), text(bands_.mean(diffuse->second)));
    } else if (const auto reflectance = curve("reflectance"); reflectance != m.spectra.end()) {
      const std::string rgb = text(bands_.mean(reflectance->second));
      scene_ += fmt::format("void mirror {} 0 0 3 {}\n", materialNames_.back(), rgb);
      scene_ += fmt::format("void metal {}_curved 0 0 5 {} 1 0\n", materialNames_.back(), rgb);
      curvedMirrors_.insert(materialNames_.back());
    } else {
      warn(m.position, fmt::format("\"{}\" ({}) has no counterpart: it is written black", m.name, m.model));
      scene_ += fmt::format("void plastic {} 0 0 5 0 0 0 0 0\n", materialNames_.back());
    }
    if (m.emission && m.emission->exitance_lm_m2 > 0) {
      warn(m.position, fmt::format("\"{}\" emits: in Radiance it does not reflect too", m.name));
      scene_ += fmt::format("void light {}_light 0 0 3 {}\n", materialNames_.back(),
                            text(times(bands_.shares(m.emission->spectrum), m.emission->exitance_lm_m2 / core::pi)));
    }
  }

  void luminaire(std::size_t index) {
    const scene::Luminaire& l = project_.environment.luminaires[index];
    const std::string name = identifier("l", l.name, index);
    luminaireNames_.push_back(name);
    const RadianceLuminaire light = radianceLuminaire(l, name);
    for (const auto& [file, content] : light.files) files_[file] = content;
    scene_ += light.pattern;
    scene_ += fmt::format("{} light {} 0 0 3 {}\n", light.modifier, name,
                          text(times(bands_.shares(world_.sourceSpectra[l.spectrum]), light.luminance)));
    scene_ += light.geometry;  // of openings without any: points and lines
  }

  [[nodiscard]] std::string modifierOf(const scene::Surface& surface, bool isCurved) const {
    if (surface.emitter != scene::none) return luminaireNames_[world_.emitters[surface.emitter].luminaire];
    const std::string& name = materialNames_[surface.material];
    if (surface.luminance > 0) return name + "_light";
    return isCurved && curvedMirrors_.contains(name) ? name + "_curved" : name;
  }

  [[nodiscard]] bool isFlatOpening(const scene::Surface& surface) const {
    if (surface.emitter == scene::none) return false;
    const auto shape = project_.environment.luminaires[world_.emitters[surface.emitter].luminaire].opening.shape;
    return shape == emitter::Opening::Shape::rectangle || shape == emitter::Opening::Shape::disc;
  }
  [[nodiscard]] Vec3 liftOf(const scene::Surface& surface) const {
    if (!isFlatOpening(surface)) return Vec3(0);
    return lift * project_.environment.luminaires[world_.emitters[surface.emitter].luminaire].frame.aim;
  }
  [[nodiscard]] bool emitsBackwards(const scene::Surface& surface) const {
    if (!isFlatOpening(surface)) return false;
    const auto& l = project_.environment.luminaires[world_.emitters[surface.emitter].luminaire];
    return !l.distribution || l.distribution->forwardFlux() < 0.9999 * l.distribution->flux();
  }

  void triangle(const std::string& modifier, const Vec3& a, const Vec3& b, const Vec3& c) {
    scene_ += fmt::format("{} polygon s{} 0 0 9 {} {} {}\n", modifier, ++count_, text(a), text(b), text(c));
  }

  void surfaces() {
    double instanced = 0;
    for (const auto& mesh : world_.instanced) instanced += double(mesh.triangles.size()) * double(mesh.places.size());
    if (double(world_.triangles.size()) + instanced > largest)
      throw core::InputError(
          {project_.file, 0, 0}, "too-large",
          "the scene has more than 5 million triangles, too many for a Radiance file; leave objects out");
    const Vec3 o = world_.origin;
    const auto place = [&](const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t index) {
      const scene::Surface& surface = world_.surfaces[index];
      const Vec3 up = o + liftOf(surface);
      triangle(modifierOf(surface, false), a + up, b + up, c + up);
      if (emitsBackwards(surface))
        triangle(modifierOf(surface, false), a + o - liftOf(surface), c + o - liftOf(surface), b + o - liftOf(surface));
    };
    for (std::size_t i = 0; i < world_.triangles.size(); ++i) {
      const auto& t = world_.triangles[i];
      place(world_.vertices[t[0]], world_.vertices[t[1]], world_.vertices[t[2]], world_.triangleSurfaces[i]);
    }
    for (const scene::InstancedMesh& mesh : world_.instanced) {
      for (const Mat4& at : mesh.places) {
        const auto apply = [&](std::uint32_t vertex) { return Vec3(at * glm::dvec4(mesh.vertices[vertex], 1)); };
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
          const auto& t = mesh.triangles[i];
          place(apply(t[0]), apply(t[1]), apply(t[2]), mesh.triangleSurfaces[i]);
        }
      }
    }
    for (const scene::PlacedPatch& patch : world_.patches) patchSurface(patch);
  }

  // Radiance's own round primitives where the placement keeps circles round; triangles else.
  void patchSurface(const scene::PlacedPatch& placed) {
    const geometry::QuadricPatch& patch = placed.patch;
    const scene::Surface& surface = world_.surfaces[placed.surface];
    const Mat4& m = patch.placement;
    const Vec3 x(m[0]), y(m[1]), z(m[2]), base = Vec3(m[3]) + world_.origin;
    const double r = glm::length(x), tolerance = 1e-9 * r;
    const bool isRound = std::abs(glm::length(y) - r) < tolerance && std::abs(glm::dot(x, y)) < tolerance * r;
    const bool isUpright = isRound && std::abs(glm::dot(x, z)) < tolerance * glm::length(z) &&
                           std::abs(glm::dot(y, z)) < tolerance * glm::length(z);
    const auto add = [&](const char* kind, const std::string& numbers, int count) {
      scene_ += fmt::format("{} {} s{} 0 0 {} {}\n", modifierOf(surface, true), kind, ++count_, count, numbers);
    };
    if (patch.kind == Kind::sphere && isUpright && std::abs(glm::length(z) - r) < tolerance) {
      add(patch.turned ? "bubble" : "sphere", fmt::format("{} {:.10g}", text(base), r), 4);
    } else if (patch.kind == Kind::disc && isRound) {
      const Vec3 front = glm::normalize(glm::cross(x, y)) * (glm::dot(glm::cross(x, y), z) < 0 ? -1.0 : 1.0) *
                         (patch.turned ? -1.0 : 1.0);
      const auto ring = [&](const Vec3& center, const Vec3& normal) {
        add("ring", fmt::format("{} {} {:.10g} {:.10g}", text(center), text(normal), patch.ratio * r, r), 8);
      };
      ring(base + liftOf(surface), front);
      if (emitsBackwards(surface)) ring(base - liftOf(surface), -front);
    } else if (patch.kind == Kind::cylinder && isUpright) {
      add(patch.turned ? "tube" : "cylinder", fmt::format("{} {} {:.10g}", text(base), text(base + z), r), 7);
    } else if (patch.kind == Kind::cone && isUpright) {
      add(patch.turned ? "cup" : "cone",
          fmt::format("{} {} {:.10g} {:.10g}", text(base), text(base + z), r, patch.ratio * r), 8);
    } else {
      const geometry::Mesh mesh = geometry::tessellate(patch, facets);
      for (const auto& t : mesh.triangles)
        triangle(modifierOf(surface, false), mesh.vertices[t[0]] + world_.origin, mesh.vertices[t[1]] + world_.origin,
                 mesh.vertices[t[2]] + world_.origin);
    }
  }

  // Points inside closed objects have no value here, so they are left out there.
  void grids() {
    std::vector<geometry::InsideTest> solids;
    for (const scene::Object& object : project_.environment.objects)
      if (object.shape.closed && !object.facesInward)
        for (const Mat4& at : scene::placesOf(object)) solids.emplace_back(object.shape, at);
    for (const analysis::Grid& grid : project_.grids) {
      std::string& points = files_[project::fileNameFor(grid.name) + ".pts"];
      for (std::size_t i = 0; i < grid.points.size(); ++i) {
        const Vec3& p = grid.points[i];
        if (std::none_of(solids.begin(), solids.end(), [&](const auto& solid) { return solid.contains(p); }))
          points += text(p) + " " + text(grid.normals[i]) + "\n";
      }
    }
  }

  void viewFile(const scene::View& view) {
    using Projection = scene::View::Projection;
    const double aspect = double(view.width) / view.height;
    std::string type = "v", size;
    if (view.projection == Projection::perspective) {
      const double v = view.verticalFov, h = 2 * std::atan(std::tan(0.5 * v) * aspect);
      size = fmt::format("-vh {:.6g} -vv {:.6g}", h / core::degree, v / core::degree);
    } else if (view.projection == Projection::orthographic) {
      type = "l";
      size = fmt::format("-vh {:.6g} -vv {:.6g}", view.span * aspect, view.span);
    } else {
      type = "a";
      size = fmt::format("-vh {0:.6g} -vv {0:.6g}", view.verticalFov / core::degree);
      if (view.projection == Projection::fisheyeEquisolid)
        warn(view.position, fmt::format("the view \"{}\" is written as an equidistant fisheye", view.name));
    }
    files_[project::fileNameFor(view.name) + ".vf"] =
        fmt::format("rvu -vt{} -vp {} -vd {} -vu {} {}\n", type, text(view.eye),
                    text(glm::normalize(view.target - view.eye)), text(view.up), size);
  }

  [[nodiscard]] std::string script() const {
    std::string lines =
        "#!/bin/sh\n"
        "# Illuminance of every grid by Radiance: pure Monte Carlo, no irradiance cache. Writes NAME.lx: one value per "
        "point.\n"
        "set -e\ncd \"$(dirname \"$0\")\"\noconv scene.rad > scene.oct\n"
        "options='-I -h -aa 0 -ab 12 -ad 128 -as 0 -lr -20 -lw 1e-3 -dt 0 -dc 1 -ds .1 -dj .95 -dr 2 -dp 0 -st 0'\n";
    for (const analysis::Grid& grid : project_.grids) {
      const std::string name = project::fileNameFor(grid.name);
      lines += fmt::format(
          "rtrace $options scene.oct < {0}.pts | awk '{{ print $1 + $2 + $3 }}' > {0}.lx\n"
          "awk '{{ sum += $1 }} END {{ printf \"%s: mean %.2f lx of %d points\\n\", \"{0}\", sum / NR, NR }}' {0}.lx\n",
          name);
    }
    return lines;
  }

  const project::Project& project_;
  core::Diagnostics& left_;
  scene::World world_;
  FluxBands bands_;
  std::vector<std::string> materialNames_, luminaireNames_;
  std::set<std::string> curvedMirrors_;
  std::string scene_;
  std::size_t count_ = 0;
  FileContents files_;
};

}  // namespace

FileContents radianceFiles(const project::Project& project, core::Diagnostics& left) {
  return Writer(project, left).write();
}

}  // namespace goniolux::pipeline
