// Stage `export`: the scene, or the results, for other programs.
#include <fmt/format.h>

#include <filesystem>

#include "pipeline/engine.h"
#include "pipeline/results_export.h"
#include "pipeline/scene_export.h"
#include "pipeline/stages.h"
#include "project/results.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

StageReport run(const StageRequest& request, core::ProgressSink&) {
  const auto asked = request.options.find("to");
  const std::string format = asked == request.options.end() ? "radiance" : asked->second;
  if (isResultsFormat(format)) return exportResults(request, format);
  if (format != "radiance" && format != "gltf")
    throw core::InputError({"goniolux export", 0, 0}, "usage",
                           fmt::format("--to is \"{}\"; it can be radiance, gltf, ods or vtu", format));
  const project::Project project = readProjectFor(request, AccuracyOf::grids);
  StageReport report;
  report.warnings = project.warnings;
  fs::path folder;
  FileContents files;
  if (format == "gltf") {
    fs::path file = request.common.output.value_or(
        (fs::path(project.folder) / (project::fileNameFor(project.name) + ".glb")).string());
    if (file.extension() != ".glb")
      throw core::InputError({"goniolux export", 0, 0}, "usage",
                             fmt::format("-o {}: a glTF file's name ends in .glb", file.string()));
    folder = file.parent_path();
    files = gltfFile(project, file.filename().string(), report.warnings);
  } else {
    folder = request.common.output.value_or((fs::path(project.folder) / "radiance").string());
    files = radianceFiles(project, report.warnings);
  }
  std::error_code failure;
  if (!folder.empty()) fs::create_directories(folder, failure);
  if (failure) throw core::RunError(fmt::format("{}: {}", folder.string(), failure.message()));
  core::Value::Array names;
  for (const auto& [name, bytes] : files) {
    const std::string path = (folder / name).string();
    core::writeFile(path, bytes);
    report.files.push_back(path);
    names.emplace_back(path);
  }
  if (format == "radiance")
    fs::permissions(folder / "calculate.sh", fs::perms::owner_exec | fs::perms::group_exec, fs::perm_options::add,
                    failure);
  report.json.set("format", format);
  report.json.set("files", std::move(names));
  report.text = format == "radiance" ? fmt::format("{} files in {}; with Radiance installed, {} calculates the grids\n",
                                                   files.size(), folder.string(), (folder / "calculate.sh").string())
                                     : fmt::format("{}\n", report.files.front());
  return report;
}

}  // namespace

Stage exportStage() {
  Stage stage;
  stage.name = "export";
  stage.title = "Write the scene, or the results, for other programs";
  stage.help =
      "For a second opinion: writes the scene as Radiance files with a script that calculates the same grids "
      "(--to radiance, into the folder given with -o, default PROJECT/radiance), or as binary glTF for modellers and "
      "viewers (--to gltf, -o FILE.glb). What the other program cannot say is a warning. Results, of the project or of "
      "a results folder, as a spreadsheet for LibreOffice, Excel or Numbers (--to ods, -o FILE.ods), or as "
      "unstructured grids for ParaView (--to vtu, a file per grid).";
  stage.inputName = "PROJECT";
  core::Parameter to;
  to.key = "to";
  to.title = "format";
  to.kind = core::ParameterKind::text;
  to.defaultText = "radiance";
  to.help = "radiance, gltf, ods or vtu";
  stage.options = {to};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
