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

}  // namespace

std::string studyPage(const std::vector<StudyPageEntry>& entries, double time_s) {
  constexpr double levels[] = {0.05, 0.02, 0.01, 0.005};
  std::string page = "# Speed against accuracy\n\n";
  page += fmt::format(
      "Made by `goniolux study` (version {}), at most {:g} s a project, {} threads of: {}, {:.0f} GiB. Each run is "
      "held against a "
      "long "
      "unbiased run by paths; below the noise of that reference (the grey line) no run can be told from another. "
      "Errors "
      "are RMS over all points of all grids. `auto` marks the method that the program chooses by itself.\n\n",
      programVersion(), time_s, core::threadCount(), processorName(), memory_GiB());
  page +=
      "CPU seconds to an RMS error, interpolated between runs; in brackets over the fastest method\'s. A dash: the "
      "method does not get there (tree leaves interreflection out) or was not given the time.\n\n"
      "| project | method | 5 % | 2 % | 1 % | 0.5 % |\n|---|---|---|---|---|---|\n";
  for (const StudyPageEntry& entry : entries) {
    if (!entry.trouble.empty()) {
      page += fmt::format("| {} | not studied: {} | | | | |\n", entry.name,
                          entry.trouble.substr(0, entry.trouble.find('\n')));
      continue;
    }
    std::vector<std::string> lines;
    for (const StudyRun& run : *entry.runs) {
      if (run.setting.line != "wavelengths" && std::find(lines.begin(), lines.end(), run.setting.line) == lines.end())
        lines.push_back(run.setting.line);
    }
    for (const std::string& line : lines) {
      page +=
          fmt::format("| [{}](#{}) | {}{} |", entry.name, entry.folder, line, line == entry.chosen ? " (`auto`)" : "");
      for (const double level : levels) {
        double best = 0;
        for (const std::string& other : lines)
          if (const double seconds = secondsTo(*entry.runs, other, level); seconds > 0 && (best == 0 || seconds < best))
            best = seconds;
        page += " " + timeText(secondsTo(*entry.runs, line, level), best) + " |";
      }
      page += "\n";
    }
  }
  for (const StudyPageEntry& entry : entries) {
    if (!entry.trouble.empty()) continue;
    page += fmt::format(
        "\n<a id=\"{0}\"></a>\n## {1}\n\n`{2}`. The reference\'s own noise is {3:.2g} "
        "%.\n\n![{1}]({0}/work-precision.svg)\n\n",
        entry.folder, entry.name, entry.path, 100 * entry.noise);
    page +=
        "| method | asked | wavelengths | CPU s | RMS % | largest % | mean % | inside % "
        "|\n|---|---|---|---|---|---|---|---|\n";
    for (const StudyRun& run : *entry.runs)
      page += fmt::format("| {}{} | {:g} % | {} | {:.3g} | {:.3g} | {:.3g} | {:+.2g} | {:.1f} |\n", run.setting.line,
                          run.isAuto ? " (`auto`)" : "", 100 * run.setting.accuracy, run.setting.spectral, run.cpu_s,
                          100 * run.rms, 100 * run.largest, 100 * run.mean, 100 * run.inside);
    if (entry.leftOut > 0) page += fmt::format("\n{} finer runs did not fit into the time.\n", entry.leftOut);
  }
  return page;
}

}  // namespace goniolux::pipeline
