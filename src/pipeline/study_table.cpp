// What a study writes of its runs: the table on a terminal, study.csv, and JSON.
#include <fmt/format.h>

#include <cmath>

#include "pipeline/study.h"

namespace goniolux::pipeline {
namespace {

std::string optionalText(const std::optional<double>& value) {
  return value ? fmt::format("{:.4g}", *value) : "";
}

std::string settingText(const StudySetting& setting) {
  return setting.change.empty() ? setting.spectral : setting.change;
}

std::string tableOf(const std::vector<StudyRun>& runs) {
  const bool colour = !runs.empty() && runs.front().delta;
  std::string text =
      fmt::format("  {:<22}{:>8}{:>22}{:>9}{:>9}{:>10}{:>9}{:>9}{}\n", "method", "asked", "wavelengths or change",
                  "CPU s", "RMS %", "largest %", "mean %", "inside", colour ? "    ΔE00" : "");
  for (const StudyRun& run : runs)
    text += fmt::format("{} {:<22}{:>6g} %{:>22}{:>9.3g}{:>9.3g}{:>10.3g}{:>9.2g}{:>7.1f} %{}\n",
                        run.isAuto ? "*" : " ", run.setting.line, 100 * run.setting.accuracy, settingText(run.setting),
                        run.cpu_s, 100 * run.rms, 100 * run.largest, 100 * run.mean, 100 * run.inside,
                        run.delta ? fmt::format("{:>8.2f}", *run.delta) : "");
  std::string front;
  for (const StudyRun* run : paretoFront(runs))
    front += fmt::format("{} {} {:g} %", front.empty() ? "" : ",", run->setting.line, 100 * run->setting.accuracy);
  return text + fmt::format("  front (nothing is both faster and nearer):{}\n", front);
}

}  // namespace

std::string studyText(const ProjectStudy& study) {
  std::string text;
  if (study.reference)
    text += fmt::format("{}, grids: reference by paths, its own noise {:.2g} %\n{}", study.name,
                        100 * study.reference->noise, tableOf(study.grids));
  if (study.pictureReference)
    text +=
        fmt::format("{}, view \"{}\" of {} × {} pixels: reference by paths, its own noise {:.2g} %\n{}", study.name,
                    study.pictureReference->view.name, study.pictureReference->view.width,
                    study.pictureReference->view.height, 100 * study.pictureReference->noise, tableOf(study.picture));
  if (study.cross) {
    const core::Value* agree = study.cross->find("agree");
    const core::Value* places = study.cross->find("disagreements");
    if (agree != nullptr && agree->isBoolean() && places != nullptr && places->isArray())
      text += agree->boolean() ? "  two independent solvers agree on the grids\n"
                               : fmt::format(
                                     "  DEFECT: two independent solvers disagree at {} points; see cross.json and "
                                     "the pictures beside it, and goniolux check --cross\n",
                                     places->array().size());
  }
  if (study.leftOut > 0)
    text += fmt::format("  {} finer runs left out: they do not fit into the time (--time-limit)\n", study.leftOut);
  return text;
}

std::string studyCsv(const ProjectStudy& study) {
  std::string csv =
      "of,line,solver,accuracy_asked_percent,spectral,change,auto,reached,cpu_s,wall_s,rays,rms_percent,"
      "largest_percent,mean_percent,delta_e00_mean,delta_e00_p95,inside_percent,peak_memory_mib\n";
  for (const std::vector<StudyRun>* runs : {&study.grids, &study.picture})
    for (const StudyRun& run : *runs)
      csv += fmt::format(
          "{},{},{},{:g},{},{},{},{},{:.4g},{:.4g},{},{:.4g},{:.4g},{:.4g},{},{},{:.4g},{:.0f}\n",
          run.setting.ofPicture ? "picture" : "grids",
          run.setting.line.find(',') == std::string::npos ? run.setting.line : "\"" + run.setting.line + "\"",
          run.setting.solver, 100 * run.setting.accuracy, run.setting.spectral, run.setting.change, run.isAuto ? 1 : 0,
          run.reached ? 1 : 0, run.cpu_s, run.wall_s, run.rays, 100 * run.rms, 100 * run.largest, 100 * run.mean,
          optionalText(run.delta), optionalText(run.deltaP95), 100 * run.inside, run.peakMemory_MiB);
  return csv;
}

core::Value toJson(const ProjectStudy& study) {
  core::Value list = core::Value::Array{}, json;
  for (const std::vector<StudyRun>* runs : {&study.grids, &study.picture})
    for (const StudyRun& run : *runs) list.push(toJson(run));
  json.set("path", study.path);
  json.set("project", study.name);
  if (study.reference) {
    json.set("reference_noise", study.reference->noise);
    json.set("auto", study.chosen);
  }
  if (study.pictureReference) {
    json.set("picture_reference_noise", study.pictureReference->noise);
    json.set("auto_of_picture", study.chosenForPicture);
  }
  json.set("runs", std::move(list));
  if (study.cross) json.set("cross", *study.cross);
  if (!study.trouble.empty()) json.set("trouble", study.trouble);
  return json;
}

core::Value toJson(const StudyRun& run) {
  core::Value json;
  json.set("line", run.setting.line);
  json.set("solver", run.setting.solver);
  json.set("accuracy", run.setting.accuracy);
  json.set("spectral", run.setting.spectral);
  json.set("of", run.setting.ofPicture ? "picture" : "grids");
  json.set("change", run.setting.change);
  json.set("work", run.setting.work);
  json.set("auto", run.isAuto);
  json.set("reached", run.reached);
  json.set("cpu_s", run.cpu_s);
  json.set("wall_s", run.wall_s);
  json.set("rays", static_cast<double>(run.rays));
  json.set("rms", run.rms);
  json.set("largest", run.largest);
  json.set("mean", run.mean);
  json.set("inside", run.inside);
  json.set("peak_memory_mib", run.peakMemory_MiB);
  if (run.delta) json.set("delta_e00_mean", *run.delta);
  if (run.deltaP95) json.set("delta_e00_p95", *run.deltaP95);
  if (!run.leftOut.empty()) json.set("left_out", run.leftOut);
  return json;
}

std::optional<StudyRun> studyRunFromJson(const core::Value& json) {
  StudyRun run;
  if (!json.isObject()) return std::nullopt;
  const auto text = [&](const char* key, std::string& into) {
    const core::Value* value = json.find(key);
    if (value == nullptr || !value->isString()) return false;
    into = value->string();
    return true;
  };
  const auto number = [&](const char* key, double& into) {
    const core::Value* value = json.find(key);
    if (value == nullptr || !value->isNumber()) return false;
    into = value->number();
    return true;
  };
  const auto yes = [&](const char* key, bool& into) {
    const core::Value* value = json.find(key);
    if (value == nullptr || !value->isBoolean()) return false;
    into = value->boolean();
    return true;
  };
  double rays = 0;
  std::string of;
  if (!text("of", of) || !text("change", run.setting.change) || !number("work", run.setting.work) ||
      !text("line", run.setting.line) || !text("solver", run.setting.solver) ||
      !number("accuracy", run.setting.accuracy) || !text("spectral", run.setting.spectral) ||
      !yes("auto", run.isAuto) || !yes("reached", run.reached) || !number("cpu_s", run.cpu_s) ||
      !number("wall_s", run.wall_s) || !number("rays", rays) || !number("rms", run.rms) ||
      !number("largest", run.largest) || !number("mean", run.mean) || !number("inside", run.inside) ||
      !number("peak_memory_mib", run.peakMemory_MiB))
    return std::nullopt;
  run.setting.ofPicture = of == "picture";
  run.rays = static_cast<std::uint64_t>(rays);
  const auto optional = [&](const char* key, std::optional<double>& into) {
    if (double value = 0; number(key, value)) into = value;
  };
  optional("delta_e00_mean", run.delta);
  optional("delta_e00_p95", run.deltaP95);
  text("left_out", run.leftOut);
  return run;
}

}  // namespace goniolux::pipeline
