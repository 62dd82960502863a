#include "geometry/mesh_import.h"

#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "geometry/arguments.h"
#include "geometry/gltf_check.h"
#include "geometry/mesh_checks.h"
#include "geometry/ply_check.h"
#include "geometry/triangulate.h"

namespace goniolux::geometry {

using core::Vec3;

namespace {

constexpr std::uintmax_t maximumBytes = 1'000'000'000;
constexpr std::size_t maximumTriangles = 20'000'000;

struct FileName {
  std::string path;
  [[noreturn]] void refuse(const std::string& why) const { throw std::invalid_argument(path + ": " + why); }
};

std::string extensionOf(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool isGltf(const std::string& path) {
  const std::string extension = extensionOf(path);
  return extension == ".gltf" || extension == ".glb";
}

// Names that the importer makes up where the file has none.
std::string givenName(const aiString& name) {
  const std::string text = name.C_Str();
  if (text == "DefaultMaterial" || text == "defaultobject" || text == "ROOT" || (!text.empty() && text[0] == '<'))
    return "";
  return text;
}

// A run of triangles with the same material and group.
struct Label {
  std::string material, group;
  bool operator<(const Label& other) const { return std::tie(material, group) < std::tie(other.material, other.group); }
};

class Collector {
 public:
  Collector(const aiScene& scene, FileName name) : scene_(scene), name_(std::move(name)) {}

  void visit(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 transform = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], node, transform);
    for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], transform);
  }

  Mesh mesh;
  std::vector<Label> labels;        ///< by part index
  std::vector<unsigned> materials;  ///< the scene's, by part index: the first that has the label

 private:
  void add(const aiMesh& source, const aiNode& node, const aiMatrix4x4& transform) {
    Label label;
    if (source.mMaterialIndex < scene_.mNumMaterials)
      label.material = givenName(scene_.mMaterials[source.mMaterialIndex]->GetName());
    // OBJ objects and groups arrive as nodes, whose meshes are named by material where there are several; STL solids
    // and lone glTF meshes have a name of their own only.
    if (&node != scene_.mRootNode) label.group = givenName(node.mName);
    if (label.group.empty()) label.group = givenName(source.mName);
    if (label.group == label.material) label.group.clear();
    const auto known = indices_.try_emplace(label, static_cast<std::uint32_t>(labels.size()));
    if (known.second) labels.push_back(label), materials.push_back(source.mMaterialIndex);

    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const bool turned = transform.Determinant() < 0;
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const aiVector3D p = transform * source.mVertices[i];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        name_.refuse(
            fmt::format("vertex {} of \"{}\" has a coordinate that is not a finite number; export the mesh again",
                        i + 1, label.group.empty() ? label.material : label.group));
      }
      mesh.vertices.emplace_back(p.x, p.y, p.z);
    }
    for (unsigned i = 0; i < source.mNumFaces; ++i) {
      const aiFace& face = source.mFaces[i];
      if (face.mNumIndices < 3) continue;  // points and lines
      std::vector<std::uint32_t> ring;
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        if (face.mIndices[k] >= source.mNumVertices) name_.refuse("a face names a vertex that does not exist");
        ring.push_back(first + face.mIndices[k]);
      }
      if (turned) std::reverse(ring.begin(), ring.end());
      addFace(ring, known.first->second, source.mTextureCoords[0], first);
    }
    if (mesh.triangles.size() > maximumTriangles) {
      name_.refuse(fmt::format("has more than {} million triangles; decimate the mesh", maximumTriangles / 1'000'000));
    }
  }

  // `coordinates`: of the vertices from number `first` on, or null.
  void addTriangle(const std::array<std::uint32_t, 3>& t, std::uint32_t part, const aiVector3D* coordinates,
                   std::uint32_t first) {
    if (coordinates != nullptr && mesh.coordinates.empty()) mesh.coordinates.resize(mesh.triangles.size());
    mesh.triangles.push_back(t);
    mesh.parts.push_back(part);
    if (coordinates == nullptr && mesh.coordinates.empty()) return;
    auto& corners = mesh.coordinates.emplace_back();
    for (std::size_t k = 0; k < 3 && coordinates != nullptr; ++k) {
      const aiVector3D& uv = coordinates[t[k] - first];
      if (std::isfinite(uv.x) && std::isfinite(uv.y)) corners[k] = {uv.x, uv.y};
    }
  }

  void addFace(const std::vector<std::uint32_t>& ring, std::uint32_t part, const aiVector3D* coordinates,
               std::uint32_t first) {
    if (ring.size() == 3) return addTriangle({ring[0], ring[1], ring[2]}, part, coordinates, first);
    std::vector<Vec3> corners;
    for (const std::uint32_t vertex : ring) corners.push_back(mesh.vertices[vertex]);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    try {
      triangles = triangulateInSpace({corners}, "the face");
    } catch (const std::invalid_argument&) {
      // Warped or crossing faces are common in scanned and sculpted models; a fan is what other programs draw there.
      for (std::uint32_t k = 1; k + 1 < ring.size(); ++k) triangles.push_back({0, k, k + 1});
    }
    for (const auto& t : triangles) addTriangle({ring[t[0]], ring[t[1]], ring[t[2]]}, part, coordinates, first);
  }

  const aiScene& scene_;
  FileName name_;
  std::map<Label, std::uint32_t> indices_;
};

// Part names and groups from labels (see the header).
void nameParts(const std::vector<Label>& labels, Shape& shape) {
  std::map<std::string, int> materials, groups;
  for (const Label& label : labels) ++materials[label.material], ++groups[label.group];
  for (const Label& label : labels) {
    std::string name;
    if (!label.material.empty() && materials[label.material] == 1) {
      name = label.material;
    } else if (label.material.empty() && !label.group.empty()) {
      name = label.group;
    } else if (label.material.empty()) {
      name = "surface";
    } else {
      name = label.group.empty() ? label.material : label.group + "/" + label.material;
    }
    while (std::count(shape.partNames.begin(), shape.partNames.end(), name) > 0) name += "'";
    shape.partNames.push_back(name);
    for (const std::string& other : {label.material, label.group}) {
      if (!other.empty() && other != name) shape.partGroups[other].push_back(name);
    }
  }
  // A part's own name wins over a group's.
  for (const std::string& name : shape.partNames) shape.partGroups.erase(name);
}

void checkFile(const FileName& name) {
  static const std::vector<std::string> formats{".obj", ".ply", ".stl", ".gltf", ".glb"};
  const std::string extension = extensionOf(name.path);
  if (std::find(formats.begin(), formats.end(), extension) == formats.end()) {
    name.refuse(fmt::format("\"{}\" is no mesh format that is read here; export as .obj, .ply, .stl, .gltf or .glb",
                            extension));
  }
  std::error_code failure;
  if (!std::filesystem::is_regular_file(name.path, failure)) name.refuse("cannot be read; check the path");
  const std::uintmax_t bytes = std::filesystem::file_size(name.path, failure);
  if (bytes == 0) name.refuse("is empty");
  if (bytes > maximumBytes) name.refuse("is larger than 1 GB; decimate the mesh");
  if (extension == ".ply") checkPly(name.path);
  if (isGltf(name.path)) checkGltf(name.path);
}

Shape make(const core::Arguments& arguments) {
  const std::string file = required<std::string>(arguments, "file");
  static const std::map<std::string, double> metres{
      {"m", 1.0}, {"mm", 1e-3}, {"cm", 1e-2}, {"ft", 0.3048}, {"in", 0.0254}};
  const std::string units = optional<std::string>(arguments, "units").value_or("m");
  const auto scale = metres.find(units);
  if (scale == metres.end()) {
    throw std::invalid_argument(fmt::format("\"units\" is \"{}\"; it can be m, mm, cm, ft or in", units));
  }
  const std::string up = optional<std::string>(arguments, "up").value_or(isGltf(file) ? "y" : "z");
  if (up != "y" && up != "z") throw std::invalid_argument(fmt::format("\"up\" is \"{}\"; it can be y or z", up));
  return importMesh(file, scale->second, up == "y");
}

const aiScene& readScene(Assimp::Importer& importer, const FileName& name) {
  checkFile(name);
  const aiScene* scene = nullptr;
  try {
    // No post-processing: the importer's own steps abort the program (assertions) on damaged faces.
    scene = importer.ReadFile(name.path, 0);
  } catch (const std::exception& error) {
    name.refuse(fmt::format("is damaged ({}); export it again", error.what()));
  }
  if (!scene || !scene->mRootNode)
    name.refuse(fmt::format("is damaged ({}); export it again", importer.GetErrorString()));
  return *scene;
}

// The picture of one material; one without `file` when it has none.
MeshPicture pictureOf(const aiScene& scene, const aiMaterial& material, const std::string& model) {
  MeshPicture picture;
  aiTextureType type = aiTextureType_BASE_COLOR;
  aiString path;
  if (material.GetTexture(type, 0, &path) != AI_SUCCESS) {
    type = aiTextureType_DIFFUSE;
    if (material.GetTexture(type, 0, &path) != AI_SUCCESS) return picture;
  }
  aiColor4D factor(1, 1, 1, 1);
  if (isGltf(model) && material.Get(AI_MATKEY_BASE_COLOR, factor) != AI_SUCCESS)
    material.Get(AI_MATKEY_COLOR_DIFFUSE, factor);
  if (!isGltf(model)) material.Get(AI_MATKEY_COLOR_DIFFUSE, factor);
  picture.factor = {factor.r, factor.g, factor.b};
  aiUVTransform moved;
  if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), moved) == AI_SUCCESS)
    picture.isMoved =
        moved.mTranslation != aiVector2D(0, 0) || moved.mScaling != aiVector2D(1, 1) || moved.mRotation != 0;
  picture.file = path.C_Str();
  if (const aiTexture* within = scene.GetEmbeddedTexture(path.C_Str())) {
    if (within->mHeight != 0 || within->pcData == nullptr) return {};  // bare pixels, of formats that are not read here
    picture.bytes.assign(reinterpret_cast<const char*>(within->pcData), within->mWidth);
    picture.extension = std::string(".") + within->achFormatHint;
    picture.file = fmt::format("{}, picture {}", model, path.C_Str());
    return picture;
  }
  std::replace(picture.file.begin(), picture.file.end(), '\\', '/');
  picture.extension = extensionOf(picture.file);
  picture.file = (std::filesystem::path(model).parent_path() / picture.file).string();
  return picture;
}

}  // namespace

std::vector<MeshPicture> meshPictures(const std::string& file) {
  const FileName name{file};
  Assimp::Importer importer;
  const aiScene& scene = readScene(importer, name);
  Collector collector(scene, name);
  collector.visit(*scene.mRootNode, aiMatrix4x4());
  Shape named;
  nameParts(collector.labels, named);
  std::vector<MeshPicture> pictures;
  for (std::size_t part = 0; part < named.partNames.size(); ++part) {
    if (collector.materials[part] >= scene.mNumMaterials) continue;
    MeshPicture picture = pictureOf(scene, *scene.mMaterials[collector.materials[part]], file);
    if (picture.file.empty()) continue;
    const auto known = std::find_if(pictures.begin(), pictures.end(), [&](const MeshPicture& other) {
      return other.file == picture.file && other.factor == picture.factor && other.isMoved == picture.isMoved;
    });
    MeshPicture& used = known == pictures.end() ? pictures.emplace_back(std::move(picture)) : *known;
    used.parts.push_back(named.partNames[part]);
  }
  return pictures;
}

Shape importMesh(const std::string& file, double scale, bool yIsUp) {
  const FileName name{file};
  Assimp::Importer importer;
  const aiScene& scene = readScene(importer, name);
  Collector collector(scene, name);
  collector.visit(*scene.mRootNode, aiMatrix4x4());
  if (collector.mesh.triangles.empty()) name.refuse("holds no triangles");

  Shape shape;
  shape.mesh = std::move(collector.mesh);
  for (Vec3& p : shape.mesh.vertices) p = scale * (yIsUp ? Vec3(p.x, -p.z, p.y) : p);
  nameParts(collector.labels, shape);
  mergeVertices(shape.mesh, 1e-9 * glm::length(boundsOf(shape.mesh).extent()));
  // Collinear triangles may hold the surface together, or lie on it beside: tightness is looked at with and without
  // them.
  const std::size_t collapsed = removeCollapsedTriangles(shape.mesh);
  const bool closedByThem = orientOutward(shape.mesh).watertight();
  const std::size_t dropped = collapsed + removeDegenerateTriangles(shape.mesh);
  shape.closed = closedByThem || (dropped > 0 && orientOutward(shape.mesh).watertight());
  if (shape.mesh.triangles.empty()) name.refuse("holds no triangle with an area");
  if (dropped > 0) {
    shape.remarks.push_back(
        fmt::format("{}: {} triangle{} without area left out", file, dropped, dropped == 1 ? "" : "s"));
  }
  return shape;
}

ObjectType meshType() {
  const auto text = [](const char* key, const char* title, const char* defaultText, const char* help) {
    core::Parameter parameter;
    parameter.key = key;
    parameter.title = title;
    parameter.kind = core::ParameterKind::text;
    parameter.defaultText = defaultText;
    parameter.help = help;
    return parameter;
  };
  core::Parameter file = text("file", "File", "", "mesh file: .obj, .ply, .stl, .gltf or .glb");
  file.kind = core::ParameterKind::file;
  file.required = true;
  ObjectType type;
  type.name = "mesh";
  type.title = "Mesh from a file";
  type.parameters = {
      file, text("units", "Units of the file", "m", "unit of the file's coordinates: m, mm, cm, ft or in"),
      text("up", "Axis that points up", "", "y or z; when left out, y for glTF and z for other formats")};
  type.make = make;
  return type;
}

}  // namespace goniolux::geometry
