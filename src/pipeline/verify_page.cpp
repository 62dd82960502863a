// The page of `verify`: what has changed, with the grids of baseline, run and their difference side by side.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/markup.h"
#include "pipeline/verify_report.h"
#include "plot/number_text.h"
#include "plot/palette.h"

namespace goniolux::pipeline {
namespace {

using core::escapedMarkup;
using Verdict = BatchProject::Verdict;

constexpr const char* style = R"(
body { font: 15px/1.5 "Source Sans 3", "Segoe UI", "DejaVu Sans", sans-serif; color: #1d2329; max-width: 72em; margin: 2.5em auto; padding: 0 1.5em; }
h1 { font-weight: 300; font-size: 2em; margin: 0 0 .2em; } h2 { font-weight: 600; font-size: 1.15em; margin: 2em 0 .4em; }
p.lead { color: #5a6670; margin-top: 0; } table { border-collapse: collapse; width: 100%; }
th { text-align: left; font-weight: 600; color: #5a6670; border-bottom: 1px solid #c9d0d6; padding: .35em .6em .35em 0; }
td { border-bottom: 1px solid #eceff1; padding: .35em .6em .35em 0; vertical-align: top; } td.n { text-align: right; font-variant-numeric: tabular-nums; }
.tag { display: inline-block; min-width: 6.5em; text-align: center; border-radius: 3px; font-size: .85em; color: #fff; }
.pass { background: #2e7d4f; } .fail { background: #b3372c; } .error { background: #7a3f9d; } .no-baseline, .not-run { background: #8a949c; }
.n { text-align: right; } .side { display: flex; gap: 1.6em; break-inside: avoid; } figure { flex: 1 1 0; min-width: 0; margin: .6em 0; } figure svg { width: 100%; height: auto; display: block; } figcaption { color: #5a6670; font-size: .9em; } pre { white-space: pre-wrap; background: #f6f7f8; padding: .8em; }
)";

std::string colourText(const plot::Rgb& c) {
  return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
}

/// Blue below, white at equal, red above; `t` from -1 to 1.
plot::Rgb divergingColour(double t) {
  const plot::Rgb end = t < 0 ? plot::Rgb{33, 102, 172} : plot::Rgb{178, 24, 43};
  const double share = std::min(1.0, std::abs(t));
  plot::Rgb colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<std::uint8_t>(std::lround(247 + share * (end[i] - 247.0)));
  return colour;
}

template <typename ColourOf>
std::string cells(const std::array<int, 2>& counts, const std::vector<double>& values, const std::string& caption,
                  ColourOf colourOf) {
  constexpr double side = 10;  // the page stretches the three to one width
  std::string svg = fmt::format("<figure><svg viewBox=\"0 0 {:.2f} {:.2f}\" shape-rendering=\"crispEdges\">",
                                side * counts[0], side * counts[1]);
  for (int j = 0; j < counts[1]; ++j) {
    for (int i = 0; i < counts[0]; ++i) {
      const double value = values[static_cast<std::size_t>(j * counts[0] + i)];
      const std::string fill = std::isfinite(value) ? colourText(colourOf(value)) : "#d5dade";
      svg += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>", side * i,
                         side * (counts[1] - 1 - j), side + 0.02, side + 0.02, fill);
    }
  }
  return svg + fmt::format("</svg><figcaption>{}</figcaption></figure>\n", escapedMarkup(caption));
}

/// Baseline, run and difference of one grid; "" where they cannot be laid side by side.
std::string gridsSideBySide(const project::ExpectedValue& expected, const project::Results& results) {
  for (const project::GridResult& grid : results.grids) {
    if (grid.name != expected.grid || !grid.counts || grid.values.size() != expected.values.size()) continue;
    double low = std::numeric_limits<double>::infinity(), high = 0, apart = 0;
    std::vector<double> difference(grid.values.size());
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      difference[i] = grid.values[i] - expected.values[i];
      for (const double value : {grid.values[i], expected.values[i]}) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
      }
      if (std::isfinite(difference[i])) apart = std::max(apart, std::abs(difference[i]));
    }
    if (!(high > 0)) return "";
    const plot::Palette& palette = plot::palettes().front();
    const auto shade = [&](double v) { return plot::colourAt(palette, high > low ? (v - low) / (high - low) : 0.5); };
    const auto range = fmt::format("{} to {} {}", plot::levelText(low), plot::levelText(high), grid.unit);
    return fmt::format("<p>{}</p><div class=\"side\">", escapedMarkup(expected.grid)) +
           cells(*grid.counts, expected.values, "expected, " + range, shade) +
           cells(*grid.counts, grid.values, "now, same colours", shade) +
           cells(*grid.counts, difference,
                 fmt::format("difference, ±{} {}: red is brighter now", plot::levelText(apart), grid.unit),
                 [&](double v) { return divergingColour(apart > 0 ? v / apart : 0); }) +
           "</div>\n";
  }
  return "";
}

std::string changesOf(const BatchProject& project) {
  std::string html = fmt::format("<h2 id=\"{0}\">{0}</h2>\n", escapedMarkup(project.path));
  if (!project.trouble.empty()) return html + fmt::format("<pre>{}</pre>\n", escapedMarkup(project.trouble));
  for (const std::string& input : project.changedInputs)
    html += fmt::format("<p>Changed input: <b>{}</b></p>\n", escapedMarkup(input));
  if (project.verdict != Verdict::changed) return html;
  html +=
      "<table><tr><th>value</th><th class=\"n\">expected</th><th class=\"n\">now</th>"
      "<th class=\"n\">difference</th><th class=\"n\">explained</th></tr>\n";
  for (const Difference& d : project.differences) {
    if (!d.changed) continue;
    const std::string name = d.of + ", " + d.quantity + (d.index ? fmt::format(" {}", *d.index) : "");
    if (!d.missing.empty()) {
      html +=
          fmt::format("<tr><td>{}</td><td colspan=\"4\">{}</td></tr>\n", escapedMarkup(name), escapedMarkup(d.missing));
      continue;
    }
    const std::string unit = d.unit == "1" ? "" : " " + d.unit;
    const std::string percent =
        d.expected.value != 0 ? fmt::format("{:+.2g} %", 100 * d.difference() / d.expected.value) : "";
    html += fmt::format(
        "<tr><td>{}</td><td class=\"n\">{}{}</td><td class=\"n\">{}{}</td><td class=\"n\">{}</td>"
        "<td class=\"n\">{:.2g}{}</td></tr>\n",
        escapedMarkup(name), plot::uncertaintyText(d.expected.value, d.expected.halfWidth()), unit,
        plot::uncertaintyText(d.found.value, d.found.halfWidth()), unit, percent, d.allowed, unit);
  }
  html += "</table>\n";
  try {
    const project::Results results = project::readResults(project.folder);
    for (const project::ExpectedValue& expected : project.baseline->values)
      if (expected.quantity == "points") html += gridsSideBySide(expected, results);
  } catch (const core::InputError&) {
    html += "<p>The results of this run are gone, so there is nothing to draw.</p>\n";
  }
  return html;
}

}  // namespace

std::string pageOf(const BatchSummary& batch) {
  std::string rows, changes;
  for (const BatchProject& project : batch.projects) {
    if (!project.ofThisShard) continue;
    const bool told =
        project.verdict == Verdict::changed || project.verdict == Verdict::broken || !project.changedInputs.empty();
    const std::string name = escapedMarkup(project.path);
    std::string inputs;
    for (const std::string& input : project.changedInputs) inputs += (inputs.empty() ? "" : "; ") + input;
    rows += fmt::format(
        "<tr><td><span class=\"tag {0}\">{0}</span></td><td>{1}</td><td>{2}</td><td class=\"n\">{3}</td>"
        "<td class=\"n\">{4:.1f} s</td></tr>\n",
        wordFor(project.verdict), told ? fmt::format("<a href=\"#{0}\">{0}</a>", name) : name, escapedMarkup(inputs),
        project.differences.size(), project.seconds);
    if (told) changes += changesOf(project);
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>goniolux verify</title>\n"
      "<style>{}</style></head><body>\n<h1>{} of {} projects unchanged</h1>\n"
      "<p class=\"lead\">{} changed, {} broken, {} without a baseline, {} not run. Goniolux {}. When nothing has "
      "changed, "
      "a batch like this one raises an alarm in at most {:g} % of the cases; {} values share that.</p>\n"
      "<table><tr><th>verdict</th><th>project</th><th>changed "
      "inputs</th><th class=\"n\">values</th><th class=\"n\">time</th></tr>\n{}</table>\n{}"
      "</body></html>\n",
      style, countOf(batch, Verdict::passed), batch.projects.size(), countOf(batch, Verdict::changed),
      countOf(batch, Verdict::broken), countOf(batch, Verdict::noBaseline), countOf(batch, Verdict::notRun),
      escapedMarkup(batch.programVersion), 100 * batch.falseAlarms, batch.values, rows, changes);
}

}  // namespace goniolux::pipeline
