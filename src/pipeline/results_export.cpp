#include "pipeline/results_export.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/document.h"
#include "pipeline/result_files.h"
#include "project/spreadsheet.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

/// A project is named by its folder or file; its results are where `run` puts them.
std::string resultsOf(const std::string& input) {
  std::error_code ignored;
  const fs::path path = input;
  if (fs::is_directory(path, ignored) && !fs::exists(path / project::resultsFileName, ignored)) {
    if (fs::exists(path / "results" / project::resultsFileName, ignored)) return (path / "results").string();
    if (fs::exists(path / "project.json", ignored))
      throw core::InputError(
          {input}, "no-results",
          fmt::format("this project has no results yet; calculate them with `goniolux run {}`", input));
  }
  if (path.filename() == "project.json") return resultsOf(path.has_parent_path() ? path.parent_path().string() : ".");
  return input;
}

}  // namespace

bool isResultsFormat(const std::string& format) {
  return format == "ods" || format == "vtu";
}

StageReport exportResults(const StageRequest& request, const std::string& format) {
  const std::string source = resultsOf(request.inputs.front());
  const project::Results results = project::readResults(source);
  std::error_code failure;
  const fs::path folder = fs::is_directory(source, failure) ? fs::path(source) : fs::path(source).parent_path();
  StageReport report;
  const auto write = [&](const fs::path& file, const std::string& bytes) {
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), failure);
    if (failure) throw core::RunError(fmt::format("{}: {}", file.parent_path().string(), failure.message()));
    core::writeFile(file.string(), bytes);
    report.files.push_back(file.string());
  };
  if (format == "ods") {
    const fs::path file = request.common.output.value_or(
        (folder / (project::fileNameFor(results.project.empty() ? "results" : results.project) + ".ods")).string());
    if (file.extension() != ".ods")
      throw core::InputError({"goniolux export", 0, 0}, "usage",
                             fmt::format("-o {}: a spreadsheet's name ends in .ods", file.string()));
    write(file, project::toSpreadsheet(results));
  } else {
    const fs::path into = request.common.output.value_or(folder.string());
    for (const project::GridResult& grid : results.grids)
      write(into / (project::fileNameFor(grid.name) + ".vtu"), gridVtu(results, grid));
  }
  report.json.set("format", format);
  report.json.set("files", core::Value::arrayOf(report.files));
  return report;
}

}  // namespace goniolux::pipeline
