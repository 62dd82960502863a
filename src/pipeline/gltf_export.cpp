// The scene as binary glTF 2.0 (Khronos Group, "glTF 2.0 Specification", 2021; KHR_lights_punctual).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "geometry/bounds.h"
#include "geometry/tessellate.h"
#include "pipeline/scene_export.h"
#include "scene/world.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"

namespace goniolux::pipeline {
namespace {

using core::Mat4;
using core::Value;
using core::Vec3;

constexpr int facets = 64;
constexpr int arrayBuffer = 34962, elementBuffer = 34963, floats = 5126, unsignedInts = 5125;  // names of OpenGL

// IEC 61966-2-1 primaries, linear, cut to what a file may say.
Value linearRgb(const spectrum::Xyz& c) {
  const double r = 3.2404542 * c.X - 1.5371385 * c.Y - 0.4985314 * c.Z,
               g = -0.9692660 * c.X + 1.8760108 * c.Y + 0.0415560 * c.Z,
               b = 0.0556434 * c.X - 0.2040259 * c.Y + 1.0572252 * c.Z;
  const auto cut = [](double v) { return std::clamp(std::round(v * 1e5) / 1e5, 0.0, 1.0); };
  return Value::Array{cut(r), cut(g), cut(b), 1.0};
}

class Writer {
 public:
  Writer(const project::Project& project, core::Diagnostics& left)
      : project_(project), left_(left), world_(scene::buildWorld(project.environment)) {}

  std::string write() {
    for (const material::Material& m : world_.materials) addMaterial(m);
    glow_ = int(materials_.size());
    materials_.push_back(Value::Object{
        {"name", "luminous opening"}, {"doubleSided", true}, {"emissiveFactor", Value::Array{1.0, 1.0, 1.0}}});
    addSurfaces();
    addInstances();
    addLights();
    return bytes();
  }

 private:
  void addMaterial(const material::Material& m) {
    const auto d65 = *spectrum::illuminant("CIE D65");
    auto curve = m.spectra.find("diffuse");
    const bool isMirror = curve == m.spectra.end() && m.spectra.contains("reflectance");
    if (isMirror) curve = m.spectra.find("reflectance");
    Value colour = Value::Array{0.5, 0.5, 0.5, 1.0};
    if (curve != m.spectra.end())
      colour = linearRgb(spectrum::tristimulus(curve->second, d65));
    else
      left_.warning(m.position, "gltf", "\"" + m.name + "\" (" + m.model + ") has no counterpart: it is written grey");
    Value entry = Value::Object{{"name", m.name}, {"doubleSided", true}};
    entry.set("pbrMetallicRoughness", Value::Object{{"baseColorFactor", std::move(colour)},
                                                    {"metallicFactor", isMirror ? 1 : 0},
                                                    {"roughnessFactor", isMirror ? 0 : 1}});
    if (m.emission) entry.set("emissiveFactor", Value::Array{1.0, 1.0, 1.0});
    materials_.push_back(std::move(entry));
  }

  int materialOf(const scene::Surface& surface) const {
    return surface.emitter != scene::none ? glow_ : int(surface.material);
  }

  std::size_t addView(const void* data, std::size_t size, int target) {
    while (binary_.size() % 4 != 0) binary_ += '\0';
    views_.push_back(Value::Object{
        {"buffer", 0}, {"byteOffset", double(binary_.size())}, {"byteLength", double(size)}, {"target", target}});
    binary_.append(static_cast<const char*>(data), size);
    return views_.size() - 1;
  }

  // A glTF mesh about `middle`; returns its index.
  int addMesh(const std::string& name, const geometry::Mesh& mesh, int material, const Vec3& middle) {
    std::vector<float> points;
    std::vector<std::uint32_t> indices;
    geometry::Bounds box;
    for (const Vec3& v : mesh.vertices) {
      const Vec3 p = v - middle;
      for (int k = 0; k < 3; ++k) points.push_back(static_cast<float>(p[k]));
      box.add(Vec3(core::Vec3f(p)));
    }
    for (const auto& t : mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
    const auto vertexView = addView(points.data(), points.size() * sizeof(float), arrayBuffer);
    accessors_.push_back(Value::Object{{"bufferView", double(vertexView)},
                                       {"componentType", floats},
                                       {"count", double(mesh.vertices.size())},
                                       {"type", "VEC3"},
                                       {"min", Value::Array{box.min.x, box.min.y, box.min.z}},
                                       {"max", Value::Array{box.max.x, box.max.y, box.max.z}}});
    const auto indexView = addView(indices.data(), indices.size() * sizeof(std::uint32_t), elementBuffer);
    accessors_.push_back(Value::Object{{"bufferView", double(indexView)},
                                       {"componentType", unsignedInts},
                                       {"count", double(indices.size())},
                                       {"type", "SCALAR"}});
    Value primitive = Value::Object{{"attributes", Value::Object{{"POSITION", double(accessors_.size() - 2)}}},
                                    {"indices", double(accessors_.size() - 1)},
                                    {"material", material}};
    meshes_.push_back(Value::Object{{"name", name}, {"primitives", Value::Array{std::move(primitive)}}});
    return int(meshes_.size()) - 1;
  }

  void addNode(Value node) {
    children_.push_back(double(nodes_.size() + 1));  // node 0 is the root
    nodes_.push_back(std::move(node));
  }

  // One mesh for each surface: an object's part, or a luminaire's opening.
  void addSurfaces() {
    std::vector<geometry::Mesh> bySurface(world_.surfaces.size());
    for (std::size_t i = 0; i < world_.triangles.size(); ++i) {
      geometry::Mesh& mesh = bySurface[world_.triangleSurfaces[i]];
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const std::uint32_t corner : world_.triangles[i]) mesh.vertices.push_back(world_.vertices[corner]);
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    for (const scene::PlacedPatch& patch : world_.patches) {
      const geometry::Mesh piece = geometry::tessellate(patch.patch, facets);
      geometry::Mesh& mesh = bySurface[patch.surface];
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.insert(mesh.vertices.end(), piece.vertices.begin(), piece.vertices.end());
      for (const auto& t : piece.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    for (std::size_t i = 0; i < bySurface.size(); ++i) {
      if (bySurface[i].triangles.empty()) continue;
      const scene::Surface& surface = world_.surfaces[i];
      std::string name = "opening";
      if (surface.object != scene::none) name = project_.environment.objects[surface.object].name;
      if (surface.emitter != scene::none)
        name = project_.environment.luminaires[world_.emitters[surface.emitter].luminaire].name;
      const int mesh = addMesh(name, bySurface[i], materialOf(surface), Vec3(0));
      addNode(Value::Object{{"name", name}, {"mesh", mesh}, {"translation", vector(world_.origin)}});
    }
  }

  void addInstances() {
    for (const scene::InstancedMesh& source : world_.instanced) {
      std::vector<std::pair<std::uint32_t, int>> parts;  // surface, mesh
      for (std::uint32_t surface = 0; surface < world_.surfaces.size(); ++surface) {
        geometry::Mesh mesh;
        for (std::size_t i = 0; i < source.triangles.size(); ++i)
          if (source.triangleSurfaces[i] == surface) mesh.triangles.push_back(source.triangles[i]);
        if (mesh.triangles.empty()) continue;
        mesh.vertices = source.vertices;
        const scene::Surface& s = world_.surfaces[surface];
        parts.emplace_back(surface, addMesh(project_.environment.objects[s.object].name, mesh, materialOf(s), Vec3(0)));
      }
      for (Mat4 place : source.places) {
        place[3] += glm::dvec4(world_.origin, 0);
        Value::Array matrix;
        for (int k = 0; k < 16; ++k) matrix.push_back(place[k / 4][k % 4]);
        for (const auto& [surface, mesh] : parts) addNode(Value::Object{{"mesh", mesh}, {"matrix", matrix}});
      }
    }
  }

  void addLights() {
    for (const scene::Luminaire& l : project_.environment.luminaires) {
      const double flux = l.flux_lm * l.maintenance * l.dimming;
      if (!(flux > 0)) continue;
      lights_.push_back(Value::Object{{"name", l.name}, {"type", "point"}, {"intensity", flux / (4 * core::pi)}});
      Value use = Value::Object{{"KHR_lights_punctual", Value::Object{{"light", double(lights_.size() - 1)}}}};
      addNode(Value::Object{{"name", l.name + " light"}, {"translation", vector(l.center)}, {"extensions", use}});
    }
  }

  static Value vector(const Vec3& v) { return Value::Array{v.x, v.y, v.z}; }

  std::string bytes() {
    while (binary_.size() % 4 != 0) binary_ += '\0';
    Value document;
    document.set("asset", Value::Object{{"version", "2.0"}, {"generator", "goniolux"}});
    document.set("scene", 0);
    document.set("scenes", Value::Array{Value::Object{{"name", project_.name}, {"nodes", Value::Array{0}}}});
    // Our z up becomes glTF's y up: a quarter turn about x.
    const double half = std::sqrt(0.5);
    Value::Array nodes{Value::Object{
        {"name", project_.name}, {"rotation", Value::Array{-half, 0.0, 0.0, half}}, {"children", children_}}};
    nodes.insert(nodes.end(), nodes_.begin(), nodes_.end());
    document.set("nodes", std::move(nodes));
    document.set("meshes", std::move(meshes_));
    document.set("materials", std::move(materials_));
    document.set("accessors", std::move(accessors_));
    document.set("bufferViews", std::move(views_));
    document.set("buffers", Value::Array{Value::Object{{"byteLength", double(binary_.size())}}});
    if (!lights_.empty()) {
      document.set("extensionsUsed", Value::Array{"KHR_lights_punctual"});
      document.set("extensions", Value::Object{{"KHR_lights_punctual", Value::Object{{"lights", std::move(lights_)}}}});
    }
    std::string json = core::toJson(document);
    while (json.size() % 4 != 0) json += ' ';
    std::string out = "glTF";
    const auto word = [&](std::size_t value) {
      const auto w = static_cast<std::uint32_t>(value);
      for (int k = 0; k < 4; ++k) out += static_cast<char>(w >> (8 * k) & 0xff);
    };
    word(2);
    word(12 + 8 + json.size() + 8 + binary_.size());
    word(json.size());
    out += "JSON" + json;
    word(binary_.size());
    out += std::string("BIN\0", 4) + binary_;
    return out;
  }

  const project::Project& project_;
  core::Diagnostics& left_;
  scene::World world_;
  int glow_ = 0;
  Value::Array materials_, accessors_, views_, meshes_, nodes_, children_, lights_;
  std::string binary_;
};

}  // namespace

FileContents gltfFile(const project::Project& project, const std::string& name, core::Diagnostics& left) {
  return {{name, Writer(project, left).write()}};
}

}  // namespace goniolux::pipeline
