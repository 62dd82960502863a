// Stage `import`: adds a model to a project: its file beside the project, an object (or several) in project.json, and a
// project material for each of the model's own.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>

#include "core/text.h"
#include "geometry/mesh_import.h"
#include "geometry/obj_file.h"
#include "geometry/objects.h"
#include "geometry/queries.h"
#include "geometry/radiance_scene.h"
#include "pipeline/geometry_findings.h"
#include "pipeline/imported_texture.h"
#include "pipeline/stages.h"
#include "pipeline/text_option.h"
#include "project/project.h"
#include "project/project_text.h"
#include "project/results.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using core::Value;
using core::Vec3;

constexpr double unknownReflectance = 0.5;

[[noreturn]] void refuse(const std::string& message) {
  throw core::InputError({"goniolux import", 0, 0}, "usage", message);
}

std::string option(const StageRequest& request, const std::string& key) {
  const auto found = request.options.find(key);
  return found == request.options.end() ? "" : found->second;
}

double metresIn(const std::string& unit) {
  static const std::map<std::string, double> metres{
      {"m", 1.0}, {"mm", 1e-3}, {"cm", 1e-2}, {"ft", 0.3048}, {"in", 0.0254}};
  const auto found = metres.find(unit);
  if (found == metres.end()) refuse(fmt::format("--units is \"{}\"; it can be m, mm, cm, ft or in", unit));
  return found->second;
}

// Names of the model's materials to names of the project's: a JSON object; "*" stands for all others.
std::map<std::string, std::string> readMapping(const std::string& file) {
  std::map<std::string, std::string> mapping;
  if (file.empty()) return mapping;
  core::Diagnostics diagnostics;
  const Value document = core::parseJson(core::readFile(file), file, diagnostics);
  if (diagnostics.hasErrors()) throw core::InputError(diagnostics);
  if (!document.isObject())
    throw core::InputError(
        document.position(), "wrong-type",
        "a mapping file is an object: { \"model's material\": \"project's material\", \"*\": \"…\" }");
  for (const auto& [from, to] : document.object()) {
    if (!to.isString())
      throw core::InputError(to.position(), "wrong-type", "the name of a material of the project is expected");
    mapping[from] = to.string();
  }
  return mapping;
}

class Import {
 public:
  explicit Import(const StageRequest& request)
      : model_(request.inputs.front()), mapping_(readMapping(option(request, "materials"))) {
    const fs::path into = option(request, "into");
    std::error_code ignored;
    file_ = fs::is_directory(into, ignored) ? into / "project.json" : into;
    before_ = core::readFile(file_.string());
    text_ = std::make_unique<project::ProjectText>(before_, file_.string());
    name_ = option(request, "name");
    if (name_.empty()) name_ = model_.stem().string();
    units_ = option(request, "units").empty() ? "m" : option(request, "units");
    up_ = option(request, "up");
    const Value* unit = text_->root().find("units");
    projectMetres_ = metresIn(unit && unit->isString() ? unit->string() : "m");
    if (const Value* materials = text_->root().find("materials"); materials && materials->isObject())
      for (const auto& [name, value] : materials->object()) known_.insert(name);
  }

  StageReport run() {
    if (core::lowerCase(model_.extension().string()) == ".rad")
      importRadiance();
    else
      importMesh();
    finish();
    return std::move(report_);
  }

 private:
  // The project's material for a name of the model: as the mapping says, else of the same name, else a new one.
  std::string materialFor(const std::string& name, double reflectance, const std::string& model = "lambert",
                          const ImportedTexture* texture = nullptr) {
    auto mapped = mapping_.find(name);
    if (mapped == mapping_.end() && !known_.contains(name)) mapped = mapping_.find("*");
    if (mapped != mapping_.end()) {
      if (!known_.contains(mapped->second))
        refuse(fmt::format("the mapping's material \"{}\" is not in the project; add it to \"materials\"",
                           mapped->second));
      return mapped->second;
    }
    if (known_.contains(name)) return name;
    Value finish = model == "mirror" ? Value::Object{{"model", "mirror"}, {"reflectance", reflectance}}
                                     : Value::Object{{"model", "lambert"}, {"diffuse", reflectance}};
    if (texture) {
      finish.set("diffuse", texture->reflectance);
      finish.set("texture", texture->texture);
    }
    text_->addMember("materials", name, finish);
    known_.insert(name);
    made_.push_back(name);
    return name;
  }

  std::string modelFile(const std::string& extension) {
    return (fs::path("models") / (project::fileNameFor(name_) + extension)).string();
  }
  void writeModel(const std::string& relative, const std::string& bytes) {
    const fs::path path = file_.parent_path() / relative;
    std::error_code failure;
    if (fs::exists(path, failure)) refuse(path.string() + " is there already; give another --name");
    fs::create_directories(path.parent_path(), failure);
    if (failure) throw core::RunError(fmt::format("{}: {}", path.parent_path().string(), failure.message()));
    core::writeFile(path.string(), bytes);
    report_.files.push_back(path.string());
  }

  bool isNew(const std::string& material) const {
    return !mapping_.contains(material) && !known_.contains(material) && !mapping_.contains("*");
  }

  // Base-colour pictures of parts whose material is new, copied beside the model; by part.
  std::map<std::string, ImportedTexture> takePictures(const geometry::Shape& shape) {
    std::map<std::string, ImportedTexture> taken;
    std::size_t number = 0;
    for (const geometry::MeshPicture& picture : geometry::meshPictures(model_.string())) {
      std::vector<std::string> parts;
      std::copy_if(picture.parts.begin(), picture.parts.end(), std::back_inserter(parts),
                   [&](const std::string& part) { return isNew(part); });
      if (parts.empty()) continue;
      const std::string names = fmt::format("{}", fmt::join(parts, ", "));
      const auto warn = [&](const std::string& text) {
        report_.warnings.warning({model_.string(), 0, 0}, "picture", text);
      };
      if (shape.mesh.coordinates.empty()) {
        warn(fmt::format("the picture of {} is left out: the model has no texture coordinates to lay it by", names));
        continue;
      }
      try {
        const std::string copy = modelFile(fmt::format("-{}{}", number + 1, picture.extension));
        const ImportedTexture texture = importedTexture(picture, copy);
        if (!texture.left.empty())
          warn(fmt::format("{}: the picture is the material's texture{}", names, texture.left));
        writeModel(copy, texture.bytes);
        ++number;
        for (const std::string& part : parts) taken[part] = texture;
        report_.text += fmt::format("{}: texture {}, mean reflectance {:.2f}\n", names, copy, texture.reflectance);
      } catch (const core::InputError& error) {
        warn(fmt::format("the picture of {} is left out: {}: {}", names, picture.file,
                         error.diagnostics().all().front().message));
      }
    }
    return taken;
  }

  void importMesh() {
    const geometry::ObjectType& type = *geometry::findObjectType("mesh");
    core::Arguments arguments{{"file", model_.string()}, {"units", units_}};
    if (!up_.empty()) arguments["up"] = up_;
    geometry::Shape shape;
    try {
      shape = type.make(arguments);
    } catch (const std::invalid_argument& wrong) {
      throw core::InputError({model_.string(), 0, 0}, "bad-shape", wrong.what());
    }
    for (const std::string& remark : shape.remarks) report_.warnings.warning({model_.string(), 0, 0}, "shape", remark);
    Value object = Value::Object{{"name", name_}, {"shape", "mesh"}};
    // A .gltf may refer to other files: what was read of it is written as one file.
    if (core::lowerCase(model_.extension().string()) == ".gltf") {
      object.set("file", modelFile(".obj"));
      writeModel(modelFile(".obj"), geometry::objText(shape.mesh, shape.partNames));
    } else {
      object.set("file", modelFile(core::lowerCase(model_.extension().string())));
      writeModel(object.find("file")->string(), core::readFile(model_.string()));
      object.set("units", units_);
      if (!up_.empty()) object.set("up", up_);
    }
    Value materials = Value::Object{};
    const std::map<std::string, ImportedTexture> pictures = takePictures(shape);
    for (const std::string& part : shape.partNames) {
      const auto picture = pictures.find(part);
      materials.set(part, materialFor(part, unknownReflectance, "lambert",
                                      picture == pictures.end() ? nullptr : &picture->second));
    }
    object.set("materials", std::move(materials));
    text_->appendTo("objects", object);
    const geometry::Bounds box = geometry::bounds(shape);
    report_.text += fmt::format("{}: {} triangles, {} part{}, from {} to {}, {}\n", name_, shape.mesh.triangles.size(),
                                shape.partNames.size(), shape.partNames.size() == 1 ? "" : "s", placeText(box.min),
                                placeText(box.max), shape.closed ? "closed" : "not closed");
    report_.json.set("triangles", double(shape.mesh.triangles.size()));
    report_.json.set("closed", shape.closed);
  }

  Value length(double ofModel) const { return ofModel * metresIn(units_) / projectMetres_; }
  Value point(const Vec3& p) const { return Value::Array{length(p.x), length(p.y), length(p.z)}; }

  void importRadiance() {
    if (!up_.empty() && up_ != "z") refuse("Radiance scenes have z up; leave --up out");
    const geometry::RadianceScene scene = geometry::readRadianceScene(core::readFile(model_.string()), model_.string());
    report_.warnings.append(scene.left);
    const auto material = [&](const std::string& name) {
      const auto own =
          std::find_if(scene.materials.rbegin(), scene.materials.rend(), [&](const auto& m) { return m.name == name; });
      if (own == scene.materials.rend()) return materialFor(name, unknownReflectance);
      if (own->type == "mirror") return materialFor(name, std::clamp(own->luminous(), 0.0, 1.0), "mirror");
      if (own->specularity > 0)
        report_.warnings.warning({model_.string(), 0, 0}, "radiance",
                                 fmt::format("\"{}\": its gloss ({}) is left out", name, own->specularity));
      const double rho = own->luminous() * (own->type == "metal" ? 1.0 : 1 - own->specularity) +
                         (own->type == "metal" ? 0.0 : own->specularity);
      return materialFor(name, std::clamp(rho, 0.0, 1.0));
    };
    if (!scene.mesh.triangles.empty()) {
      geometry::Mesh mesh = scene.mesh;
      for (Vec3& v : mesh.vertices) v *= metresIn(units_);
      writeModel(modelFile(".obj"), geometry::objText(mesh, scene.partNames));
      Value materials = Value::Object{};
      for (const std::string& part : scene.partNames) materials.set(part, material(part));
      text_->appendTo(
          "objects",
          Value::Object{
              {"name", name_}, {"shape", "mesh"}, {"file", modelFile(".obj")}, {"materials", std::move(materials)}});
    }
    std::size_t number = 0;
    for (const geometry::RadianceRound& r : scene.rounds) {
      Value object = Value::Object{{"name", fmt::format("{} {}", name_, ++number)}};
      using Kind = geometry::RadianceRound::Kind;
      switch (r.kind) {
        case Kind::sphere:
          object.set("shape", "sphere");
          object.set("center", point(r.a));
          object.set("radius", length(std::abs(r.r0)));
          break;
        case Kind::cylinder:
        case Kind::cone:
          object.set("shape", r.kind == Kind::cylinder ? "cylinder" : "cone");
          object.set("base", point(r.a));
          object.set("top", point(r.b));
          object.set("radius", length(r.r0));
          if (r.kind == Kind::cone) object.set("top_radius", length(r.r1));
          object.set("caps", "none");
          break;
        case Kind::ring:
          object.set("shape", "revolution");
          object.set("profile", Value::Array{Value::Array{length(r.r1), 0.0}, Value::Array{length(r.r0), 0.0}});
          object.set("center", point(r.a));
          object.set("axis", Value::Array{r.b.x, r.b.y, r.b.z});
          break;
      }
      object.set("material", material(r.material));
      text_->appendTo("objects", object);
    }
    report_.text += fmt::format("{}: {} triangles of polygons, {} round surfaces, {} not understood\n", name_,
                                scene.mesh.triangles.size(), scene.rounds.size(), scene.left.all().size());
    report_.json.set("triangles", double(scene.mesh.triangles.size()));
    report_.json.set("round", double(scene.rounds.size()));
  }

  // The project with the model must be as good as it was without: else nothing has happened.
  void finish() {
    core::writeFile(file_.string(), text_->text());
    try {
      (void)project::readProject(file_.string());
    } catch (const core::InputError&) {
      core::writeFile(file_.string(), before_);
      for (const std::string& written : report_.files) {
        std::error_code ignored;
        fs::remove(written, ignored);
      }
      throw;
    }
    report_.files.push_back(file_.string());
    if (!made_.empty()) {
      report_.warnings.warning(
          {model_.string(), 0, 0}, "unmapped",
          fmt::format("new in the project's \"materials\", as no mapping names them: {}; check their reflectances",
                      fmt::join(made_, ", ")));
    }
    report_.json.set("project", file_.string());
    report_.json.set("unmapped", Value::arrayOf(made_));
  }

  fs::path model_, file_;
  std::map<std::string, std::string> mapping_;
  std::string before_, name_, units_, up_;
  double projectMetres_ = 1;
  std::unique_ptr<project::ProjectText> text_;
  std::set<std::string> known_;
  std::vector<std::string> made_;
  StageReport report_;
};

StageReport run(const StageRequest& request, core::ProgressSink&) {
  return Import(request).run();
}

}  // namespace

Stage importStage() {
  Stage stage;
  stage.name = "import";
  stage.title = "Add a model to a project";
  stage.help =
      "Copies a model (OBJ, PLY, STL, glTF, GLB) into the project's models/ and adds it to project.json, whose other "
      "text "
      "stays as it is. Also reads surfaces of Radiance scenes (.rad): polygon, sphere, bubble, cylinder, tube, cone, "
      "cup, "
      "ring, with plastic, metal and mirror. The model's materials become the project's by a mapping file or by name; "
      "the "
      "others are made new and listed, with their base-colour pictures (OBJ map_Kd, glTF) as textures. What was not "
      "understood is listed with its line.";
  stage.inputName = "MODEL";
  stage.options = {
      textOption("into", "project", "", "the project that the model is added to", true),
      textOption("name", "name", "", "of the object; the file's when left out", false),
      textOption("units", "units of the model", "m", "m, mm, cm, ft or in", false),
      textOption("up", "axis that points up", "", "y or z; when left out, y for glTF and z for others", false),
      textOption("materials", "mapping file", "",
                 "JSON: { \"model's material\": \"project's material\", \"*\": \"for all others\" }", false)};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
