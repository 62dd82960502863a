#include "pipeline/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "core/document.h"
#include "pipeline/helper_process.h"
#include "pipeline/stages.h"
#include "plot/levels.h"
#include "plot/palette.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using project::GridResult;
using project::Results;

constexpr double timeLimit_s = 60;

[[noreturn]] void badOption(const std::string& message) {
  throw core::InputError({}, "bad-option", message);
}

std::string joinedNames(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

PlotRequest requestOf(const StageRequest& request) {
  PlotRequest plot;
  const auto option = [&](const char* key) {
    const auto found = request.options.find(key);
    return found == request.options.end() ? std::string() : found->second;
  };
  if (const std::string format = option("format"); format == "png" || format == "svg") {
    plot.formats = {format};
  } else if (!format.empty() && format != "both") {
    badOption(fmt::format("--format {}: there is no such format; take png, svg or both", format));
  }
  if (const std::string levels = option("levels"); !levels.empty() && levels != "auto") {
    const auto list = plot::parseLevels(levels);
    if (!list)
      badOption(fmt::format("--levels \"{}\": write numbers with commas between, e.g. 100,200,300,500", levels));
    plot.map.levels = *list;
  }
  if (const std::string palette = option("palette"); !palette.empty()) {
    std::vector<std::string> names;
    for (const plot::Palette& known : plot::palettes()) names.push_back(known.name);
    if (!plot::findPalette(palette)) {
      badOption(fmt::format("--palette {}: there is no such palette; take one of {}", palette, joinedNames(names)));
    }
    plot.map.palette = palette;
  }
  if (const std::string shading = option("shading"); shading == "smooth") {
    plot.map.banded = false;
  } else if (!shading.empty() && shading != "bands") {
    badOption(fmt::format("--shading {}: take bands or smooth", shading));
  }
  if (const std::string size = option("size"); !size.empty()) {
    const auto number = [](std::string_view text) {
      int value = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      return error == std::errc() && end == text.data() + text.size() ? value : 0;
    };
    const std::size_t cross = size.find('x');
    plot.map.width = number(std::string_view(size).substr(0, cross));
    plot.map.height = cross == std::string::npos ? 0 : number(std::string_view(size).substr(cross + 1));
    const auto fits = [](int pixels) { return pixels >= 500 && pixels <= 8000; };
    if (!fits(plot.map.width) || !fits(plot.map.height)) {
      badOption(fmt::format("--size {}: write WIDTHxHEIGHT in pixels, each from 500 to 8000, e.g. 1600x1100", size));
    }
  }
  plot.grid = option("grid");
  return plot;
}

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  PlotRequest plot = requestOf(request);
  const std::string& input = request.inputs.front();
  const Results results = project::readResults(input);
  std::error_code ignored;
  const std::string inputFolder = fs::is_directory(input, ignored) ? input : fs::path(input).parent_path().string();
  plot.folder = request.common.output.value_or(inputFolder.empty() ? "." : inputFolder);
  if (!plot.grid.empty()) {
    std::vector<std::string> names;
    for (const GridResult& grid : results.grids) names.push_back("\"" + grid.name + "\"");
    if (std::find(names.begin(), names.end(), "\"" + plot.grid + "\"") == names.end()) {
      badOption(
          fmt::format("--grid \"{}\": the results have no such grid; they have {}", plot.grid, joinedNames(names)));
    }
  }

  StageReport report;
  const std::optional<Outline> outline = outlineFor(results, inputFolder, report.warnings);
  progress.progress("plot", 0, "");
  PlotOutcome outcome = drawPlots(results, outline ? &*outline : nullptr, plot);
  progress.progress("plot", 1, "");
  report.warnings.append(outcome.warnings);
  report.files = outcome.pictures;
  report.files.insert(report.files.end(), outcome.figures.begin(), outcome.figures.end());
  report.json.set("pictures", core::Value::arrayOf(outcome.pictures));
  report.json.set("figures", core::Value::arrayOf(outcome.figures));
  core::Value warnings = core::Value::Array{};
  for (const core::Diagnostic& warning : report.warnings.all()) warnings.push(warning.message);
  report.json.set("warnings", warnings);
  return report;
}

core::Parameter textOption(const char* key, const char* title, const char* fallback, const char* help) {
  core::Parameter parameter;
  parameter.key = key;
  parameter.title = title;
  parameter.kind = core::ParameterKind::text;
  parameter.defaultText = fallback;
  parameter.help = help;
  return parameter;
}

}  // namespace

std::string drawFigure(const std::string& figure, const std::vector<std::string>& pictures) {
  const std::string helper = findHelper("goniolux-plot", "GONIOLUX_PLOT");
  if (helper.empty())
    return "the program goniolux-plot is not installed beside this one; set GONIOLUX_PLOT to its path";
  std::vector<std::string> arguments{figure};
  arguments.insert(arguments.end(), pictures.begin(), pictures.end());
  ProcessEnd end = runHelper(helper, arguments, timeLimit_s);
  while (!end.errors.empty() && end.errors.back() == '\n') end.errors.pop_back();
  const std::string said = end.errors.empty() ? "" : ": " + end.errors;
  switch (end.how) {
    case ProcessEnd::How::exited:
      if (end.code == 0) return "";
      return end.errors.empty() ? fmt::format("{} ended with code {}", helper, end.code) : end.errors;
    case ProcessEnd::How::killed:
      return fmt::format("{} was ended by signal {}{}", helper, end.code, said);
    case ProcessEnd::How::timedOut:
      return fmt::format("{} took longer than {:g} s{}", helper, timeLimit_s, said);
    case ProcessEnd::How::notStarted:
      break;
  }
  return fmt::format("{} could not be started{}", helper, said);
}

std::optional<Outline> outlineFor(const Results& results, const std::string& folder, core::Diagnostics& warnings) {
  const std::string file = (fs::path(folder) / outlineFileName).string();
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    warnings.warning({file}, "no-outline",
                     "there is no outline of the scene: plots show neither furniture nor luminaires");
    return std::nullopt;
  }
  core::Diagnostics diagnostics;
  const core::Value document = core::parseJson(core::readFile(file), file, diagnostics);
  if (diagnostics.hasErrors()) throw core::InputError(diagnostics);
  Outline outline = outlineFromJson(document);
  if (outline.projectHash != results.projectHash) {
    warnings.warning(
        {file}, "other-outline",
        "the outline belongs to another version of the project: plots show neither furniture nor luminaires; make "
        "it again with `goniolux illuminate`");
    return std::nullopt;
  }
  return outline;
}

PlotOutcome drawPlots(const Results& results, const Outline* outline, const PlotRequest& request) {
  PlotOutcome outcome;
  std::error_code error;
  fs::create_directories(request.folder, error);
  if (error) throw core::RunError(fmt::format("{}: the folder cannot be made: {}", request.folder, error.message()));
  for (const GridResult& grid : results.grids) {
    if (!request.grid.empty() && grid.name != request.grid) continue;
    const bool dark =
        std::all_of(grid.values.begin(), grid.values.end(), [](double value) { return std::isnan(value); });
    if (dark) {
      outcome.warnings.warning({}, "nothing-to-draw", fmt::format("grid \"{}\" has no value to draw", grid.name));
      continue;
    }
    const std::string base = (fs::path(request.folder) / project::fileNameFor(grid.name)).string();
    const std::string figure = base + ".figure.json";
    core::writeFile(figure, core::toJson(plot::toJson(planMapOf(results, grid, outline, request.map))));
    outcome.figures.push_back(figure);
    std::vector<std::string> pictures;
    for (const std::string& format : request.formats) {
      pictures.push_back(base + "." + format);
      fs::remove(pictures.back(), error);  // an earlier picture must not pass for this one
    }
    if (const std::string trouble = drawFigure(figure, pictures); !trouble.empty()) {
      outcome.warnings.warning(
          {}, "cannot-draw",
          fmt::format("drawing is not possible here: {}; the numbers are in the .csv and .vtp files", trouble));
    }
    for (const std::string& picture : pictures) {
      if (fs::exists(picture, error)) outcome.pictures.push_back(picture);
    }
  }
  return outcome;
}

Stage plotStage() {
  Stage stage;
  stage.name = "plot";
  stage.title = "Draw the results: false colours, isolux lines, plan";
  stage.help =
      "Reads a results folder (or its grids.json) and draws each grid in false colour with labelled isolux lines, "
      "luminaires "
      "and furniture, as NAME.png and NAME.svg. Needs no display. Where drawing is not possible it says so; the "
      "numbers are in "
      "NAME.csv and NAME.vtp all the same.";
  stage.inputName = "RESULTS";
  stage.options = {
      textOption("format", "Picture format", "both", "png, svg or both"),
      textOption("levels", "Isolux levels", "auto",
                 "numbers with commas between, e.g. 100,200,300,500; auto chooses round steps"),
      textOption("palette", "Colours", "viridis", "viridis, false-colour or grey"),
      textOption("shading", "Shading", "bands", "bands: one colour between two levels; smooth: a gradual passage"),
      textOption("grid", "Grid", "", "name of the only grid to draw; all grids by default"),
      textOption("size", "Size in pixels", "",
                 "WIDTHxHEIGHT, e.g. 1600x1100; by default as the plan's proportions ask"),
  };
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
