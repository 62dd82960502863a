#include "project/project.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "core/sha256.h"
#include "project/format.h"
#include "project/grid_reader.h"
#include "project/lighting_scene_reader.h"
#include "project/luminaire_reader.h"
#include "project/material_reader.h"
#include "project/object_reader.h"
#include "project/reading.h"
#include "project/results.h"
#include "project/scene_checks.h"
#include "project/section_reader.h"
#include "project/settings_reader.h"
#include "project/texture_reader.h"
#include "project/view_reader.h"

namespace goniolux::project {
namespace {

namespace fs = std::filesystem;

/// The project.json that PROJECT means.
fs::path projectFile(const std::string& path) {
  std::error_code ignored;
  const fs::path given = path;
  const fs::path file = fs::is_directory(given, ignored) ? given / "project.json" : given;
  if (!fs::exists(file, ignored)) {
    throw core::InputError({file.string(), 0, 0}, "missing-file",
                           "there is no project here; give a folder that holds a project.json, or such a file");
  }
  return file;
}

/// Format and version decide whether anything else can be understood.
void checkFormat(const core::Value& root) {
  if (!root.isObject())
    throw core::InputError(root.position(), "wrong-type",
                           "a project is an object: { \"format\": \"goniolux-project\", … }");
  const core::Value* format = root.find("format");
  if (!format || !format->isString() || format->string() != "goniolux-project") {
    throw core::InputError(format ? format->position() : root.position(), "wrong-format",
                           "this is no project file: it must hold \"format\": \"goniolux-project\", \"version\": 1");
  }
  const core::Value* version = root.find("version");
  if (!version || !version->isNumber() || version->number() != 1) {
    throw core::InputError(version ? version->position() : root.position(), "wrong-version",
                           "this program reads \"version\": 1 of the project format");
  }
}

double metresIn(const std::string& unit) {
  if (unit == "mm") return 0.001;
  if (unit == "cm") return 0.01;
  if (unit == "ft") return 0.3048;  // international foot and inch, exact since 1959
  if (unit == "in") return 0.0254;
  return 1;
}

/// Names are unique among their kind, and so are the result files made from them.
class Names {
 public:
  explicit Names(Reading& reading) : reading_(reading) {}

  void addAll(const core::Value* section, const char* kind, bool namesFiles) {
    if (!section || !section->isArray()) return;
    std::map<std::string, int> lines;
    for (const core::Value& entry : section->array()) {
      const core::Value* name = entry.find("name");
      if (!name || !name->isString()) continue;
      const auto [known, isNew] = lines.try_emplace(name->string(), name->position().line);
      if (!isNew) {
        reading_.error(*name, "duplicate-name",
                       fmt::format("another {} (line {}) is named \"{}\" too; give each its own name", kind,
                                   known->second, name->string()));
      } else if (namesFiles) {
        addFile(*name);
      }
    }
  }

 private:
  void addFile(const core::Value& name) {
    const std::string file = fileNameFor(name.string());
    if (file.find_first_not_of(".-") == std::string::npos) {
      reading_.error(name, "file-name",
                     fmt::format("no file name can be made from \"{}\"; it needs a letter or a digit", name.string()));
      return;
    }
    if (file.size() > 200) {
      reading_.error(name, "file-name", "the name is too long for a file; keep it below 200 bytes");
      return;
    }
    const auto [known, isNew] = files_.try_emplace(file, name.position().line);
    if (isNew) return;
    reading_.error(
        name, "file-name",
        fmt::format("\"{}\" would write the same result files ({}.*) as the name in line {}; rename one of them",
                    name.string(), file, known->second));
  }

  Reading& reading_;
  std::map<std::string, int> files_;
};

/// sha256 over the hashes of all inputs in order and the settings that change results.
std::string hashOf(const Project& project, const Overrides& overrides) {
  std::string text = "goniolux-project 1\n";
  for (const InputFile& input : project.inputs) text += input.sha256 + " " + input.path + "\n";
  if (overrides.scene) text += "scene " + *overrides.scene + "\n";
  return core::sha256(text + core::toJson(settingsDocument(project.settings)));
}

void readSections(const core::Value& root, Project& project, const Overrides& overrides, Reading& reading) {
  SectionReader section(root, rootSection(), reading);
  project.name = section.text("name").value_or(fs::absolute(project.folder).lexically_normal().filename().string());
  project.units = section.choice("units").value_or("m");
  reading.metresPerUnit = metresIn(project.units);
  scene::Environment& environment = project.environment;
  if (const auto* materials = section.find("materials")) {
    environment.materials = readMaterials(*materials, reading);
    readTextures(*materials, environment, reading);
  }
  if (const auto* objects = section.find("objects"))
    environment.objects = readObjects(*objects, environment.materials, reading);
  if (const auto* luminaires = section.find("luminaires")) readLuminaires(*luminaires, environment, reading);
  if (const auto* scenes = section.find("scenes")) {
    project.scenes = readLightingScenes(*scenes, environment.luminaires, reading);
  }
  if (overrides.scene) applyLightingScene(*overrides.scene, project.scenes, environment.luminaires, reading);
  if (const auto* grids = section.find("grids")) project.grids = readGrids(*grids, reading);
  if (const auto* observers = section.find("observers")) project.observers = readObservers(*observers, reading);
  if (const auto* views = section.find("views")) project.views = readViews(*views, reading);
  if (const auto* requirements = section.find("requirements")) {
    project.requirements =
        readRequirements(*requirements, namesIn(section.find("grids")), namesIn(section.find("observers")), reading);
  }
  project.settings = readSettings(section.find("settings"), overrides.settings, reading);
  Names names(reading);
  names.addAll(section.find("grids"), "grid", true);
  names.addAll(section.find("views"), "view", true);
  names.addAll(section.find("observers"), "observer", false);
  names.addAll(section.find("scenes"), "scene", false);
}

}  // namespace

Project readProject(const std::string& path, const Overrides& overrides) {
  const std::string file = projectFile(path).string();
  return readProjectText(core::readFile(file), file, overrides);
}

Project readProjectText(const std::string& text, const std::string& fileName, const Overrides& overrides) {
  const fs::path file = fileName;
  Project project;
  project.file = file.string();
  project.folder = file.has_parent_path() ? file.parent_path().string() : ".";
  Reading reading(project.folder);
  reading.addInput(file.filename().string(), text);
  const core::Value root = core::parseJson(text, project.file, reading.diagnostics);
  if (reading.diagnostics.hasErrors()) throw core::InputError(reading.diagnostics);
  checkFormat(root);
  readSections(root, project, overrides, reading);
  if (!reading.diagnostics.hasErrors()) checkScene(project, reading.diagnostics);
  if (reading.diagnostics.hasErrors()) throw core::InputError(reading.diagnostics);
  project.warnings = reading.diagnostics;
  project.inputs = reading.inputs();
  project.hash = hashOf(project, overrides);
  return project;
}

}  // namespace goniolux::project
