// The stage `report`: results and their project as report.html and report.pdf.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "pipeline/engine.h"
#include "pipeline/helper_process.h"
#include "pipeline/plot.h"
#include "pipeline/report_input.h"
#include "pipeline/stages.h"
#include "pipeline/text_option.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using project::Project;
using project::Results;

constexpr double printLimit_s = 300;

struct ReportOptions {
  std::string resultsFolder, folder, projectPath;
  std::optional<report::Units> units;
  report::Language language = report::Language::english;
  bool pdf = true;
};

[[noreturn]] void badOption(const std::string& message) {
  throw core::InputError({}, "bad-option", message);
}

ReportOptions optionsOf(const StageRequest& request) {
  ReportOptions options;
  const auto option = [&](const char* key) {
    const auto found = request.options.find(key);
    return found == request.options.end() ? std::string() : found->second;
  };
  std::error_code ignored;
  const std::string& input = request.inputs.front();
  const fs::path parent = fs::path(input).parent_path();
  options.resultsFolder = fs::is_directory(input, ignored) ? input : parent.empty() ? "." : parent.string();
  options.folder = request.common.output.value_or(options.resultsFolder);
  options.projectPath = option("project");
  if (const std::string units = option("units"); units == "metric") {
    options.units = report::Units::metric;
  } else if (units == "imperial") {
    options.units = report::Units::imperial;
  } else if (!units.empty()) {
    badOption(fmt::format("--units {}: take metric (m, lx) or imperial (ft, fc)", units));
  }
  if (const std::string language = option("language"); language == "de" || language == "german") {
    options.language = report::Language::german;
  } else if (!language.empty() && language != "en" && language != "english") {
    badOption(fmt::format("--language {}: take en or de", language));
  }
  if (const std::string format = option("format"); format == "html") {
    options.pdf = false;
  } else if (!format.empty() && format != "both") {
    badOption(fmt::format("--format {}: take html or both", format));
  }
  return options;
}

/// The project of the results: as named, else the folder above them. Nothing, and a warning, when it is not there.
std::optional<Project> projectOf(const ReportOptions& options, core::Diagnostics& warnings) {
  std::string path = options.projectPath;
  if (path.empty()) {
    const fs::path above = fs::absolute(options.resultsFolder).lexically_normal();
    path = (above.has_filename() ? above.parent_path() : above.parent_path().parent_path()).string();
    std::error_code ignored;
    if (!fs::exists(fs::path(path) / "project.json", ignored)) {
      warnings.warning({options.resultsFolder}, "no-project",
                       "the project is not in the folder above, so luminaires, surfaces and renderings are left out; "
                       "name it with --project");
      return std::nullopt;
    }
  }
  return project::readProject(path);
}

std::string today(report::Language language) {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  localtime_r(&now, &parts);
  // ISO 8601 is read in every language; German business letters write the day first.
  return language == report::Language::german
             ? fmt::format("{:02}.{:02}.{}", parts.tm_mday, parts.tm_mon + 1, parts.tm_year + 1900)
             : fmt::format("{}-{:02}-{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday);
}

void addProject(const Project& project, const ReportOptions& options, report::Report& content,
                core::Diagnostics& warnings) {
  content.luminaires = luminaireTypes(project, warnings);
  content.surfaces = roomSurfaces(project);
  content.floorArea_m2 = floorArea(project);
  content.contributions = contributionsOf(content.results, project, options.resultsFolder);
  content.speedChart = speedChartOf(project);
  for (const scene::View& view : project.views) {
    const fs::path file = fs::path(options.resultsFolder) / (project::fileNameFor(view.name) + ".png");
    std::error_code ignored;
    if (fs::exists(file, ignored))
      content.renderings.push_back({view.name, "image/png", core::readFile(file.string())});
  }
  std::string stale;
  for (const std::string& file : staleInputs(content.results, project)) stale += (stale.empty() ? "" : ", ") + file;
  if (!stale.empty()) {
    content.remarks.push_back("the project has changed since these results were calculated: " + stale);
    warnings.warning({project.file}, "stale-results", content.remarks.back() + "; make them again with `goniolux run`");
  }
}

/// Where a program of the system is; "" when it is not installed.
std::string findInPath(const char* name, const char* environmentVariable) {
  if (const char* named = std::getenv(environmentVariable); named != nullptr && *named != '\0') return named;
  const char* path = std::getenv("PATH");
  std::string rest = path ? path : "/usr/bin:/bin";
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const fs::path candidate = fs::path(rest.substr(0, colon)) / name;
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored)) return candidate.string();
    rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
  }
  return {};
}

/// A sentence why there is no PDF, "" when there is.
std::string print(const std::string& html, const std::string& pdf) {
  const std::string printer = findInPath("weasyprint", "GONIOLUX_WEASYPRINT");
  if (printer.empty()) return "the program weasyprint is not installed (Debian: apt-get install weasyprint)";
  const std::string part = pdf + ".part";
  ProcessEnd end = runHelper(printer, {"--quiet", html, part}, printLimit_s);
  std::error_code error;
  if (end.how == ProcessEnd::How::exited && end.code == 0) {
    fs::rename(part, pdf, error);
    return error ? fmt::format("{}: {}", pdf, error.message()) : "";
  }
  fs::remove(part, error);
  while (!end.errors.empty() && end.errors.back() == '\n') end.errors.pop_back();
  const std::size_t last = end.errors.rfind('\n');  // of a Python traceback, what went wrong
  return fmt::format("{} failed{}{}", printer, end.errors.empty() ? "" : ": ",
                     last == std::string::npos ? end.errors : end.errors.substr(last + 1));
}

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  const ReportOptions options = optionsOf(request);
  StageReport stage;
  report::Report content;
  content.results = project::readResults(request.inputs.front());
  content.language = options.language;
  content.date = today(options.language);
  const std::optional<Project> project = projectOf(options, stage.warnings);
  if (project) addProject(*project, options, content, stage.warnings);
  const bool feet = project && (project->units == "ft" || project->units == "in");
  content.units = options.units.value_or(feet ? report::Units::imperial : report::Units::metric);
  const std::optional<Outline> outline = outlineFor(content.results, options.resultsFolder, stage.warnings);
  if (outline) {
    content.roomSize = outline->high - outline->low;
    content.plan = planOf(*outline, content.results, content.luminaires);
  }
  const std::size_t steps = content.results.grids.size() + 1;
  for (std::size_t i = 0; i < content.results.grids.size(); ++i) {
    progress.progress("report", static_cast<double>(i) / static_cast<double>(steps), "maps");
    content.maps.push_back(
        gridMap(content.results, i, outline ? &*outline : nullptr, content.language, content.units, stage.warnings));
    if (progress.cancelled()) {
      stage.unfinished = true;
      return stage;
    }
  }
  std::error_code error;
  fs::create_directories(options.folder, error);
  if (error) throw core::RunError(fmt::format("{}: the folder cannot be made: {}", options.folder, error.message()));
  const std::string html = (fs::path(options.folder) / "report.html").string();
  const std::string pdf = (fs::path(options.folder) / "report.pdf").string();
  core::writeFile(html, report::htmlOf(content));
  stage.files.push_back(html);
  if (options.pdf) {
    progress.progress("report", 1 - 1 / static_cast<double>(steps), "PDF");
    fs::remove(pdf, error);  // an earlier one must not pass for this one
    const std::string trouble = print(html, pdf);
    if (trouble.empty())
      stage.files.push_back(pdf);
    else
      stage.warnings.warning({}, "no-pdf", fmt::format("there is no PDF: {}; {} has the same pages", trouble, html));
  }
  progress.progress("report", 1, "");
  stage.json.set("files", core::Value::arrayOf(stage.files));
  core::Value warnings = core::Value::Array{};
  for (const core::Diagnostic& warning : stage.warnings.all()) warnings.push(warning.message);
  stage.json.set("warnings", warnings);
  return stage;
}

}  // namespace

Stage reportStage() {
  Stage stage;
  stage.name = "report";
  stage.title = "Write the report: PDF and HTML";
  stage.help =
      "From a results folder and its project: cover, requirements, plan, luminaire schedule and sheets, maps and "
      "tables "
      "with intervals, renderings, what was left out, and how it was made. Writes report.html (one file with "
      "everything "
      "in it) and report.pdf beside the results, or into the folder given with -o.";
  stage.inputName = "RESULTS";
  stage.options = {
      textOption("project", "project of the results", "",
                 "folder or project.json (default: the folder above the results)", false),
      textOption("units", "units", "", "metric or imperial (default: imperial where the project is in feet or inches)",
                 false),
      textOption("language", "language", "en", "en or de", false),
      textOption("format", "what is written", "both", "html or both", false),
  };
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
