// Stage `new`: writes a project to begin with: a rectangular room with its luminaires laid out by the lumen method.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "photometry/metrics.h"
#include "photometry/photometric_file.h"
#include "pipeline/lumen_method.h"
#include "pipeline/stages.h"
#include "pipeline/text_option.h"
#include "project/reading.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using core::Value;

[[noreturn]] void refuse(const std::string& message) {
  throw core::InputError({"goniolux new", 0, 0}, "usage", message);
}

double numberFrom(const std::string& text, const std::string& option) {
  // ".7" and "0.7" alike.
  const std::string whole = text.starts_with('.') ? "0" + text : text;
  double value = 0;
  const auto [end, error] = std::from_chars(whole.data(), whole.data() + whole.size(), value);
  if (error != std::errc() || end != whole.data() + whole.size() || !std::isfinite(value))
    refuse(fmt::format("--{}: \"{}\" is no number", option, text));
  return value;
}

// Numbers between separators: "6x4x3", ".7/.5/.2".
std::vector<double> numbersFrom(const std::string& text, char separator, std::size_t count, const std::string& option,
                                const std::string& example) {
  std::vector<double> numbers;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    numbers.push_back(numberFrom(text.substr(begin, end - begin), option));
    begin = end + 1;
  }
  if (numbers.size() != count) refuse(fmt::format("--{} needs {} numbers, as in {}", option, count, example));
  return numbers;
}

std::string option(const StageRequest& request, const std::string& key, const std::string& standard) {
  const auto found = request.options.find(key);
  return found == request.options.end() ? standard : found->second;
}

// Where the photometric file is: as given, else among the program's own luminaires.
struct FoundFile {
  fs::path path;
  bool isOwn = false;
};
FoundFile findLuminaire(const std::string& name) {
  std::error_code ignored;
  if (fs::is_regular_file(name, ignored)) return {name, false};
  std::string searched = name;
  for (const fs::path& folder : project::programDataFolders()) {
    const fs::path path = folder / "luminaires" / name;
    if (fs::is_regular_file(path, ignored)) return {path, true};
    searched += ", " + path.string();
  }
  refuse(fmt::format("--luminaire: there is no file \"{}\"; looked for {}", name, searched));
}

// Height of the luminous opening's centre below the plane that the luminaire hangs from.
double drop(const photometry::StatedOpening& opening) {
  return 0.5 * opening.height;
}

// Light that goes up needs room to come down again: a luminaire is hung where more than this share of its light goes
// up.
constexpr double upwardShareToHang = 0.4, usualSuspension = 0.5, mostSuspension = 0.25;

double upwardShare(const photometry::TabulatedDistribution& distribution) {
  const auto zones = photometry::zonalLumens(distribution);
  const double up = std::accumulate(zones.begin() + 9, zones.end(), 0.0);
  return up / std::accumulate(zones.begin(), zones.end(), 0.0);
}

/// Between the ceiling and the top of the luminaire, m.
double suspensionOf(const StageRequest& request, const RoomForLayout& room,
                    const photometry::TabulatedDistribution& distribution) {
  const std::string asked = option(request, "suspension", "auto");
  if (asked != "auto") {
    const double suspension = numberFrom(asked, "suspension");
    if (!(suspension >= 0)) refuse("--suspension must not be negative");
    return suspension;
  }
  if (upwardShare(distribution) <= upwardShareToHang) return 0;
  return std::min(usualSuspension, mostSuspension * (room.height - room.workPlane));
}

// Points along an edge, EN 12464-1: steps of at most 0.2 * 5^log10(d), d the edge or 10 m.
int pointsAlong(double edge) {
  const double step = 0.2 * std::pow(5, std::log10(std::min(edge, 10.0)));
  return std::max(2, static_cast<int>(std::ceil(edge / step)));
}

Value vector(double x, double y, double z) {
  return Value::Array{x, y, z};
}

double rounded(double metres) {
  return std::round(metres * 1e4) / 1e4;
}

Value lambert(double reflectance) {
  return Value::Object{{"model", "lambert"}, {"diffuse", reflectance}};
}

Value documentOf(const std::string& name, const RoomForLayout& room, const Layout& layout, const std::string& luminaire,
                 double target) {
  const double l = room.length, w = room.width, h = room.height;
  Value document;
  document.set("format", "goniolux-project");
  document.set("version", 1);
  document.set("name", name);
  document.set("units", "m");
  document.set("materials",
               Value::Object{
                   {"ceiling", lambert(room.ceiling)}, {"walls", lambert(room.walls)}, {"floor", lambert(room.floor)}});
  document.set("objects",
               Value::Array{Value::Object{
                   {"name", "room"},
                   {"shape", "box"},
                   {"min", vector(0, 0, 0)},
                   {"max", vector(l, w, h)},
                   {"facing", "inward"},
                   {"materials", Value::Object{{"floor", "floor"}, {"walls", "walls"}, {"ceiling", "ceiling"}}}}});
  const double stepX = l / layout.along, stepY = w / layout.across;
  document.set("luminaires", Value::Array{Value::Object{
                                 {"name", "L"},
                                 {"photometry", luminaire},
                                 {"position", vector(rounded(stepX / 2), rounded(stepY / 2), rounded(room.mounting))},
                                 {"array", Value::Object{{"counts", Value::Array{layout.along, layout.across}},
                                                         {"u", vector(rounded(stepX), 0, 0)},
                                                         {"v", vector(0, rounded(stepY), 0)}}},
                                 {"maintenance", room.maintenance}}});
  document.set("grids", Value::Array{Value::Object{{"name", "work plane"},
                                                   {"origin", vector(0, 0, room.workPlane)},
                                                   {"u", vector(l, 0, 0)},
                                                   {"v", vector(0, w, 0)},
                                                   {"counts", Value::Array{pointsAlong(l), pointsAlong(w)}},
                                                   {"normal", vector(0, 0, 1)}}});
  document.set("views", Value::Array{Value::Object{
                            {"name", "corner"},
                            {"eye", vector(rounded(0.05 * l), rounded(0.05 * w), rounded(std::min(1.6, 0.6 * h)))},
                            {"target", vector(rounded(0.6 * l), rounded(0.6 * w), rounded(std::min(1.2, 0.45 * h)))},
                            {"fov", Value::Object{{"horizontal", 80}}},
                            {"width", 400},
                            {"height", 300}}});
  document.set("requirements",
               Value::Array{Value::Object{{"grid", "work plane"}, {"mean_lx", Value::Object{{"min", target}}}}});
  document.set("settings", Value::Object{{"accuracy", Value::Object{{"grid", "2 %"}, {"image", "15 %"}}}});
  return document;
}

RoomForLayout roomFrom(const StageRequest& request) {
  RoomForLayout room;
  const auto size = numbersFrom(option(request, "size", ""), 'x', 3, "size", "6x4x3");
  room.length = size[0], room.width = size[1], room.height = size[2];
  for (const double edge : size)
    if (!(edge >= 0.5 && edge <= 1000)) refuse("--size: each edge must be from 0.5 to 1000 m");
  const auto reflectances =
      numbersFrom(option(request, "reflectances", "0.7/0.5/0.2"), '/', 3, "reflectances", "0.7/0.5/0.2");
  room.ceiling = reflectances[0], room.walls = reflectances[1], room.floor = reflectances[2];
  for (const double rho : reflectances)
    if (!(rho >= 0 && rho <= 0.95)) refuse("--reflectances: ceiling, walls and floor are each from 0 to 0.95");
  room.workPlane = numberFrom(option(request, "work-plane", "0.8"), "work-plane");
  room.maintenance = numberFrom(option(request, "maintenance", "0.8"), "maintenance");
  if (!(room.workPlane >= 0 && room.workPlane < room.height)) refuse("--work-plane must lie between floor and ceiling");
  if (!(room.maintenance > 0 && room.maintenance <= 1)) refuse("--maintenance must be above 0 and at most 1");
  return room;
}

StageReport run(const StageRequest& request, core::ProgressSink&) {
  if (request.inputs.front() != "room")
    refuse(fmt::format("\"{}\" is nothing that can be made; it can be: room", request.inputs.front()));
  RoomForLayout room = roomFrom(request);
  const double target = numberFrom(option(request, "target", "500"), "target");
  if (!(target > 0 && target <= 1e5)) refuse("--target must be above 0 and at most 100000 lx");
  const FoundFile luminaire = findLuminaire(option(request, "luminaire", ""));
  const photometry::PhotometricFile file = photometry::readPhotometricFile(luminaire.path.string());
  room.flux_lm = file.distribution->flux();
  if (!(room.flux_lm > 0)) refuse("--luminaire: the file's luminous flux is 0; take another");
  const double suspension = suspensionOf(request, room, *file.distribution);
  room.mounting = room.height - suspension - drop(file.opening);
  if (!(room.mounting > room.workPlane)) refuse("the luminaires would hang below the work plane; make the room higher");
  const Layout layout = layoutFor(room, *file.distribution, target);

  const fs::path folder = request.common.output.value_or("room");
  std::error_code failure;
  if (fs::exists(folder / "project.json", failure)) {
    refuse(fmt::format("{} is there already; give another folder with -o", (folder / "project.json").string()));
  }
  fs::create_directories(folder, failure);
  StageReport report;
  if (failure) throw core::RunError(fmt::format("{}: {}", folder.string(), failure.message()));
  const std::string name = luminaire.path.filename().string();
  if (!luminaire.isOwn) {
    core::writeFile((folder / name).string(), core::readFile(luminaire.path.string()));
    report.files.push_back((folder / name).string());
  }
  const fs::path target_file = folder / "project.json";
  const std::string title = fmt::format("Room {} m x {} m x {} m", room.length, room.width, room.height);
  core::writeFile(target_file.string(), core::toJson(documentOf(title, room, layout, name, target)));
  report.files.push_back(target_file.string());
  report.warnings = file.warnings;

  report.json.set("project", target_file.string());
  report.json.set("suspension_m", suspension);
  report.json.set("counts", Value::Array{layout.along, layout.across});
  report.json.set("luminaires", layout.along * layout.across);
  report.json.set("utilisation", layout.utilisation);
  report.json.set("room_index", layout.roomIndex);
  report.json.set("spacing_to_height", layout.spacingToHeight);
  report.json.set("expected_mean_lx", layout.meanIlluminance_lx);
  const double up = upwardShare(*file.distribution);
  const std::string hung = suspension > 0 ? fmt::format("{:.2f} m below the ceiling; {:.0f} % of their light goes up\n",
                                                        suspension, 100 * up)
                                          : "";
  report.text = fmt::format(
      "{}: {} x {} luminaires of {:.0f} lm, steps {:.2f} m and {:.2f} m\n{}"
      "lumen method: room index {:.2f}, utilisation {:.2f}, maintenance {}, about {:.0f} lx on the work plane\n"
      "next: goniolux run {}\n",
      target_file.string(), layout.along, layout.across, room.flux_lm, room.length / layout.along,
      room.width / layout.across, hung, layout.roomIndex, layout.utilisation, room.maintenance,
      layout.meanIlluminance_lx, folder.string());
  return report;
}

}  // namespace

Stage newStage() {
  Stage stage;
  stage.name = "new";
  stage.title = "Begin a project";
  stage.help =
      "`goniolux new room` writes a project with a rectangular room, luminaires of one kind in rows on or below its "
      "ceiling, a "
      "grid on the work plane, a view and the requirement, into the folder given with -o (default: room). The number "
      "of "
      "luminaires follows from the lumen method: the fewest whose maintained mean illuminance reaches the target.";
  stage.inputName = "KIND";
  stage.options = {
      textOption("size", "length x width x height", "", "LENGTHxWIDTHxHEIGHT in metres, e.g. 6x4x3", true),
      textOption("luminaire", "photometric file", "", "an LM-63 or EULUMDAT file, or one of the program's own", true),
      textOption("reflectances", "reflectances", "0.7/0.5/0.2", "ceiling/walls/floor", false),
      textOption("target", "mean illuminance", "500", "maintained, lx", false),
      textOption("maintenance", "maintenance factor", "0.8", "of the luminaires", false),
      textOption("suspension", "gap between ceiling and luminaires", "auto",
                 "metres; auto: 0, or 0.5 m where more than 40 % of their light goes up", false),
      textOption("work-plane", "height of the work plane", "0.8", "metres above the floor", false)};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
