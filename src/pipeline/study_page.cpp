// The page about the studies of several projects.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/parallel.h"
#include "pipeline/engine.h"
#include "pipeline/study.h"

namespace goniolux::pipeline {
namespace {

constexpr double levels[] = {0.05, 0.02, 0.01, 0.005};
constexpr double leastDrawn = 1e-6;  // RMS of exact runs, which have no logarithm

double memory_GiB() {
  std::ifstream info("/proc/meminfo");
  std::string key;
  double kibibytes = 0;
  info >> key >> kibibytes;
  return kibibytes / (1024 * 1024);
}

std::string processorName() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  return "unknown processor";
}

/// CPU seconds to an RMS error on a line of the chart, between its runs (both logarithmic); 0: it does not get there.
double secondsTo(const std::vector<StudyRun>& runs, const std::string& line, double rms) {
  std::vector<const StudyRun*> own;
  for (const StudyRun& run : runs)
    if (run.setting.line == line) own.push_back(&run);
  std::sort(own.begin(), own.end(), [](const auto* a, const auto* b) { return a->rms > b->rms; });
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i]->rms > rms) continue;
    if (i == 0) return own[i]->cpu_s;
    const StudyRun &coarse = *own[i - 1], &fine = *own[i];
    const double share = std::log(coarse.rms / rms) / std::log(coarse.rms / std::max(fine.rms, leastDrawn));
    return coarse.cpu_s * std::pow(fine.cpu_s / coarse.cpu_s, share);
  }
  return 0;
}

std::string timeText(double seconds, double best) {
  if (!(seconds > 0)) return "–";
  return fmt::format("{:.2g} s ({:.2g})", seconds, best > 0 ? seconds / best : 1);
}

/// Rows of the summary: each solver's CPU time to some errors, over the fastest one's.
std::string summaryRows(const std::string& name, const std::string& anchor, const std::vector<StudyRun>& runs,
                        const std::string& chosen) {
  std::vector<std::string> solvers;
  for (const StudyRun& run : runs)
    if (run.setting.line == run.setting.solver &&
        std::find(solvers.begin(), solvers.end(), run.setting.line) == solvers.end())
      solvers.push_back(run.setting.line);
  std::string rows;
  for (const std::string& solver : solvers) {
    rows += fmt::format("| [{}](#{}) | {}{} |", name, anchor, solver, solver == chosen ? " (`auto`)" : "");
    for (const double level : levels) {
      double best = 0;
      for (const std::string& other : solvers)
        if (const double seconds = secondsTo(runs, other, level); seconds > 0 && (best == 0 || seconds < best))
          best = seconds;
      rows += " " + timeText(secondsTo(runs, solver, level), best) + " |";
    }
    rows += "\n";
  }
  return rows;
}

std::string runTable(const std::vector<StudyRun>& runs) {
  const bool colour = !runs.empty() && runs.front().delta;
  std::string table = fmt::format(
      "| method | asked | wavelengths or change | CPU s | RMS % | largest % | mean % | inside % |{}\n"
      "|---|---|---|---|---|---|---|---|{}\n",
      colour ? " ΔE00 |" : "", colour ? "---|" : "");
  for (const StudyRun& run : runs)
    table += fmt::format("| {}{} | {:g} % | {} | {:.3g} | {:.3g} | {:.3g} | {:+.2g} | {:.1f} |{}\n", run.setting.line,
                         run.isAuto ? " (`auto`)" : "", 100 * run.setting.accuracy,
                         run.setting.change.empty() ? run.setting.spectral : "`" + run.setting.change + "`", run.cpu_s,
                         100 * run.rms, 100 * run.largest, 100 * run.mean, 100 * run.inside,
                         colour ? fmt::format(" {:.2f} |", run.delta.value_or(0)) : "");
  return table;
}

/// What two independent solvers say of each other.
std::string crossText(const ProjectStudy& study) {
  if (!study.cross) return "";
  const core::Value* agree = study.cross->find("agree");
  const core::Value* places = study.cross->find("disagreements");
  if (agree == nullptr || !agree->isBoolean() || places == nullptr || !places->isArray()) return "";
  return agree->boolean() ? " `path` and `gather` agree at every point."
                          : fmt::format(" **`path` and `gather` disagree at {} points**: a defect of one of them.",
                                        places->array().size());
}

}  // namespace

std::string studyPage(const std::vector<ProjectStudy>& studies, double time_s) {
  std::string page = "# Speed against accuracy\n\n";
  page += fmt::format(
      "Made by `goniolux study` (version {}), at most {:.0f} s a project, {} threads of: {}, {:.0f} GiB. Each run is "
      "held "
      "against a long unbiased run by paths; below the noise of that reference (dotted) no run can be told from "
      "another. "
      "Errors are RMS over all points of all grids, those of pictures over 95 % of the pixels of the first view, 96 "
      "pixels wide. "
      "`auto` marks the method that the program chooses by itself.\n\n",
      programVersion(), time_s, core::threadCount(), processorName(), memory_GiB());
  page +=
      "CPU seconds to an RMS error, interpolated between runs; in brackets over the fastest method's. A dash: the "
      "method "
      "does not get there (tree leaves interreflection out) or was not given the time.\n\n"
      "| project | method | 5 % | 2 % | 1 % | 0.5 % |\n|---|---|---|---|---|---|\n";
  for (const ProjectStudy& study : studies) {
    const std::string folder = project::fileNameFor(study.path);
    if (!study.trouble.empty()) {
      page += fmt::format("| {} | not studied: {} | | | | |\n", study.name,
                          study.trouble.substr(0, study.trouble.find('\n')));
      continue;
    }
    page += summaryRows(study.name, folder, study.grids, study.chosen);
    page += summaryRows(study.name + ", picture", folder, study.picture, study.chosenForPicture);
  }
  for (const ProjectStudy& study : studies) {
    if (!study.trouble.empty()) continue;
    const std::string folder = project::fileNameFor(study.path);
    page += fmt::format("\n<a id=\"{0}\"></a>\n## {1}\n\n`{2}`.", folder, study.name, study.path);
    if (study.reference) {
      page += fmt::format(
          " The reference of the grids has a noise of {0:.2g} %.{1}\n\n![{2}]({3}/work-precision.svg)\n\n{4}",
          100 * study.reference->noise, crossText(study), study.name, folder, runTable(study.grids));
    }
    if (study.pictureReference)
      page += fmt::format(
          "\nThe view “{0}”; its reference has a noise of {1:.2g} %.\n\n![{2}, "
          "picture]({3}/picture-precision.svg)\n\n{4}",
          study.pictureReference->view.name, 100 * study.pictureReference->noise, study.name, folder,
          runTable(study.picture));
    if (study.leftOut > 0) page += fmt::format("\n{} finer runs did not fit into the time.\n", study.leftOut);
  }
  return page;
}

}  // namespace goniolux::pipeline
