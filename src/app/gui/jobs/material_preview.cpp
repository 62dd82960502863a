#include "app/gui/jobs/material_preview.h"

#include <QTemporaryDir>

#include "app/gui/document/json_pointer.h"
#include "app/gui/document/placement.h"
#include "image/image_file.h"
#include "pipeline/engine.h"
#include "pipeline/render.h"

namespace goniolux::gui {

using core::Value;

namespace {

constexpr double mostSeconds = 4;
constexpr int pictureSize = 168;  // pixels

}  // namespace

std::string previewProject(const Source& source, const std::string& material, const std::string& light) {
  core::Diagnostics ignored;
  const Value root = core::parseJson(source.text, source.file, ignored);
  const Value* finish = valueAt(root, under("/materials", material));
  if (finish == nullptr) throw core::RunError("the project has no material " + material + " any more");
  // The project's own unit, for patterns are as large as it says.
  const double metre = 1 / metresPerUnit(root);
  const auto point = [&](double x, double y, double z) { return Value(Value::Array{x * metre, y * metre, z * metre}); };
  const auto grey = [](double reflectance) {
    return Value(Value::Object{{"model", "lambert"}, {"diffuse", reflectance}});
  };
  Value project = Value::Object{{"format", "goniolux-project"}, {"version", 1}, {"name", "preview"}};
  if (const Value* units = root.find("units")) project.set("units", *units);
  Value materials = Value::Object{{material, *finish}};
  // A texture mixes in another finish by its name: all others come along.
  if (const Value* all = root.find("materials"); all != nullptr && all->isObject())
    for (const auto& [name, other] : all->object())
      if (name != material) materials.set(name, other);
  materials.set("preview floor", grey(0.3));
  materials.set("preview walls", grey(0.65));
  project.set("materials", materials);
  project.set("objects", Value::Array{Value::Object{{"name", "room"},
                                                    {"shape", "box"},
                                                    {"min", point(-2, -2, 0)},
                                                    {"max", point(2, 2, 2.8)},
                                                    {"facing", "inward"},
                                                    {"materials", Value::Object{{"floor", "preview floor"},
                                                                                {"walls", "preview walls"},
                                                                                {"ceiling", "preview walls"}}}},
                                      Value::Object{{"name", "ball"},
                                                    {"shape", "sphere"},
                                                    {"center", point(0, 0, 0.502)},
                                                    {"radius", 0.5 * metre},
                                                    {"material", material}}});
  project.set(
      "luminaires",
      Value::Array{Value::Object{
          {"name", "lamp"},
          {"photometry", "cosine"},
          {"flux", 6000},
          {"spectrum", light},
          {"position", point(-0.9, -0.9, 2.6)},
          {"shape", Value::Object{{"rectangle", Value::Object{{"length", 0.9 * metre}, {"width", 0.9 * metre}}}}}}});
  project.set("views", Value::Array{Value::Object{{"name", "ball"},
                                                  {"eye", point(0.3, -1.9, 0.95)},
                                                  {"target", point(0, 0, 0.48)},
                                                  {"fov", 38},
                                                  {"width", pictureSize},
                                                  {"height", pictureSize}}});
  project.set("settings", Value::Object{{"accuracy", Value::Object{{"image", "15 %"}}}});
  return core::toJson(project);
}

std::shared_ptr<const ShownImage> materialPreview(const Source& source, const std::string& material,
                                                  const std::string& light, core::ProgressSink& progress) {
  try {
    const project::Project project = project::readProjectText(previewProject(source, material, light), source.file);
    const pipeline::Engine engine(project, true);
    const QTemporaryDir folder;
    const pipeline::RenderedView done = pipeline::renderToFile(project, engine, project.views.front(),
                                                               folder.path().toStdString(), mostSeconds, progress);
    if (progress.cancelled()) return nullptr;
    return shownImage(image::readImage(done.file), {});
  } catch (const std::exception& error) {
    auto failed = std::make_shared<ShownImage>();
    failed->failure = QString::fromUtf8(error.what());
    return failed;
  }
}

}  // namespace goniolux::gui
