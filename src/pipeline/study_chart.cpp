// The work-precision chart of a study.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/engine.h"
#include "pipeline/study.h"

namespace goniolux::pipeline {
namespace {

constexpr double believed = 0.5;  // a run of which fewer intervals hold the reference is biased

// Exact runs have no place on a logarithmic axis.
core::Vec2 placeOf(const StudyRun& run) {
  return {std::max(run.cpu_s, 1e-4), std::max(100 * run.rms, 1e-4)};
}

/// What stands beside a dot whose line is no ladder of accuracies.
std::string labelOf(const StudySetting& setting) {
  if (!setting.change.empty()) {
    const std::string value = setting.change.substr(setting.change.find('=') + 1);
    return setting.change.starts_with("luminaire.points") && value != "1" ? value + " × " + value : value;
  }
  return setting.spectral == "auto" ? "" : setting.spectral;
}

/// "interreflection between matt surfaces (solver tree), but for ..." without what follows.
std::string firstWords(const std::string& sentence) {
  return sentence.substr(0, std::min(sentence.find(" ("), sentence.find(',')));
}

/// The place of a line in the legend: solvers as they are registered, then what is changed.
std::size_t rankOf(const std::string& line) {
  const auto& types = solver::solverTypes();
  return static_cast<std::size_t>(
      std::find_if(types.begin(), types.end(), [&](const auto& type) { return line.starts_with(type.name); }) -
      types.begin());
}

std::string nameOf(const StudySetting& setting) {
  const std::string label = labelOf(setting);
  return label.empty() ? setting.line : setting.line + " " + label;
}

}  // namespace

std::vector<const StudyRun*> paretoFront(const std::vector<StudyRun>& runs) {
  std::vector<const StudyRun*> front;
  for (const StudyRun& run : runs) {
    const bool beaten = std::any_of(runs.begin(), runs.end(), [&](const StudyRun& other) {
      return (other.cpu_s < run.cpu_s && other.rms <= run.rms) || (other.cpu_s <= run.cpu_s && other.rms < run.rms);
    });
    if (!beaten) front.push_back(&run);
  }
  std::sort(front.begin(), front.end(), [](const auto* a, const auto* b) { return a->cpu_s < b->cpu_s; });
  return front;
}

std::vector<const StudyRun*> plateaus(const std::vector<StudyRun>& runs) {
  std::vector<const StudyRun*> nearest;
  for (const StudyRun& run : runs) {
    const auto sameLine = [&](const StudyRun& other) { return other.setting.line == run.setting.line; };
    if (std::any_of(runs.begin(), runs.end(), [&](const StudyRun& r) { return sameLine(r) && r.inside >= believed; }))
      continue;
    const auto known =
        std::find_if(nearest.begin(), nearest.end(), [&](const StudyRun* other) { return sameLine(*other); });
    if (known == nearest.end())
      nearest.push_back(&run);
    else if (run.rms < (*known)->rms)
      *known = &run;
  }
  return nearest;
}

plot::LineChart workPrecisionChart(const StudyChartText& text, const std::vector<StudyRun>& runs) {
  plot::LineChart chart;
  chart.title = text.project;
  chart.subtitle = "What accuracy costs: each run against one long unbiased reference, " + text.measured;
  chart.x = {"CPU time / s", true};
  chart.y = {fmt::format("RMS error of the {} / %", text.measured), true};
  for (const StudyRun& run : runs) {
    auto line = std::find_if(chart.curves.begin(), chart.curves.end(),
                             [&](const plot::ChartCurve& curve) { return curve.name == run.setting.line; });
    if (line == chart.curves.end()) line = chart.curves.insert(line, {run.setting.line, {}, true});
    line->points.push_back(placeOf(run));
    if (const std::string label = labelOf(run.setting); !label.empty())
      chart.notes.push_back({label, placeOf(run), false});
  }
  // A solver has the same colour in every chart.
  std::stable_sort(chart.curves.begin(), chart.curves.end(),
                   [](const auto& a, const auto& b) { return rankOf(a.name) < rankOf(b.name); });
  for (plot::ChartCurve& curve : chart.curves)
    std::sort(curve.points.begin(), curve.points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  for (const StudyRun* run : paretoFront(runs)) chart.front.push_back(placeOf(*run));
  if (chart.front.size() > 1) chart.frontName = "front: nothing is both faster and nearer";
  // Below its own noise the reference cannot tell one run from another.
  if (text.noise > 0) chart.levels.push_back({"the reference's own noise", 100 * text.noise, 0});
  for (const StudyRun* run : plateaus(runs)) {
    const std::string cause = run->leftOut.empty() ? "" : ": without " + firstWords(run->leftOut);
    chart.levels.push_back({fmt::format("{} stays at {:.2g} %{}", nameOf(run->setting), 100 * run->rms, cause),
                            100 * run->rms, placeOf(*run).x});
  }
  for (const StudyRun& run : runs)
    if (run.isAuto) {
      chart.notes.push_back({"auto", placeOf(run), true});
      chart.facts.push_back(fmt::format("auto chose {} at ± {:g} %: {:.2g} s, RMS {:.2g} %{}", run.setting.solver,
                                        100 * run.setting.accuracy, run.cpu_s, 100 * run.rms,
                                        run.delta ? fmt::format(", ΔE00 {:.2g}", *run.delta) : ""));
    }
  chart.footer = fmt::format("goniolux {} · the reference\'s own noise is {:.2g} % · {} {}", programVersion(),
                             100 * text.noise, text.count, text.measured);
  return chart;
}

}  // namespace goniolux::pipeline
