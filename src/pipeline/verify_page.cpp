// The page of `verify`: what has changed, with the grids of baseline, run and their difference side by side.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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
.n { text-align: right; white-space: nowrap; } .quiet { color: #5a6670; font-size: .9em; } h3 { font-weight: 600; font-size: 1em; margin: 1.2em 0 0; break-after: avoid; }
.side { display: flex; break-inside: avoid; margin-right: -1.4em; } figure { flex: 1 1 0; min-width: 0; margin: .6em 1.4em .6em 0; }
figure svg { width: 100%; height: auto; display: block; } figure svg.scale { height: .7em; margin-top: .6em; } figcaption { color: #5a6670; font-size: .9em; margin-bottom: .4em; }
.ends { display: flex; justify-content: space-between; font-size: .85em; font-variant-numeric: tabular-nums; } pre { white-space: pre-wrap; background: #f6f7f8; padding: .8em; }
@media print { body { font-size: 10pt; margin: 0; } }
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

/// What the colours of a map mean, from its lowest to its highest value.
struct Scale {
  double low = 0, high = 0;
  std::string unit;
  [[nodiscard]] double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

template <typename ColourOf>
std::string scaleBar(const Scale& scale, ColourOf colourOf) {
  constexpr int steps = 60;
  std::string svg = fmt::format("<svg class=\"scale\" viewBox=\"0 0 {} 2\" preserveAspectRatio=\"none\">", steps);
  for (int i = 0; i < steps; ++i)
    svg += fmt::format("<rect x=\"{}\" width=\"1.1\" height=\"2\" fill=\"{}\"/>", i,
                       colourText(colourOf((i + 0.5) / steps)));
  const auto label = [](double value) { return plot::levelText(value); };
  return svg + fmt::format("</svg><div class=\"ends\"><span>{}</span><span>{}</span><span>{} {}</span></div>",
                           label(scale.low), label((scale.low + scale.high) / 2), label(scale.high), scale.unit);
}

/// A map with its caption above and its scale below; `colourOf` takes the share of the way along the scale.
template <typename ColourOf>
std::string cells(const std::array<int, 2>& counts, const std::vector<double>& values, const std::string& caption,
                  const Scale& scale, ColourOf colourOf) {
  constexpr double side = 10;  // the page stretches the three to one width
  std::string svg = fmt::format(
      "<figure><figcaption>{}</figcaption><svg viewBox=\"0 0 {:.2f} {:.2f}\" shape-rendering=\"crispEdges\">",
      escapedMarkup(caption), side * counts[0], side * counts[1]);
  for (int j = 0; j < counts[1]; ++j) {
    for (int i = 0; i < counts[0]; ++i) {
      const double value = values[static_cast<std::size_t>(j * counts[0] + i)];
      const std::string fill = std::isfinite(value) ? colourText(colourOf(scale.share(value))) : "#d5dade";
      svg += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>", side * i,
                         side * (counts[1] - 1 - j), side + 0.02, side + 0.02, fill);
    }
  }
  return svg + "</svg>" + scaleBar(scale, colourOf) + "</figure>\n";
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
    const auto shade = [&](double t) { return plot::colourAt(palette, t); };
    const Scale scale{low, high, grid.unit}, around{-apart, apart, grid.unit};
    return fmt::format("<h3>{}</h3><div class=\"side\">", escapedMarkup(expected.grid)) +
           cells(*grid.counts, expected.values, "expected", scale, shade) +
           cells(*grid.counts, grid.values, "now, in the same colours", scale, shade) +
           cells(*grid.counts, difference, "difference: red is brighter now", around,
                 [](double t) { return divergingColour(2 * t - 1); }) +
           "</div>\n";
  }
  return "";
}

/// "work plane, point 12 at (1.2, 0.4, 0.8) m; 15 of 108 points differ".
std::string placeOf(const Difference& d, const std::optional<project::Results>& results) {
  std::string text = escapedMarkup(d.of + ", " + (d.quantity == "u0" ? "U0" : d.quantity));
  if (!d.index) return text;
  text += fmt::format(" {}", *d.index);
  if (results)
    for (const project::GridResult& grid : results->grids)
      if (grid.name == d.of && *d.index < grid.points.size()) {
        const core::Vec3& p = grid.points[*d.index];
        text += fmt::format(" at ({:.2f}, {:.2f}, {:.2f}) m", p.x, p.y, p.z);
      }
  if (d.pointsChanged > 1)
    text += fmt::format("<br><span class=\"quiet\">{} of {} points differ; this one most</span>", d.pointsChanged,
                        d.points);
  return text;
}

std::optional<project::Results> resultsOf(const BatchProject& project) {
  try {
    return project::readResults(project.folder);
  } catch (const core::InputError&) {
    return std::nullopt;
  }
}

std::string changesOf(const BatchProject& project) {
  std::string html = fmt::format("<h2 id=\"{0}\">{0}</h2>\n", escapedMarkup(project.path));
  if (!project.trouble.empty()) return html + fmt::format("<pre>{}</pre>\n", escapedMarkup(project.trouble));
  for (const std::string& input : project.changedInputs)
    html += fmt::format("<p>Changed input: <b>{}</b></p>\n", escapedMarkup(input));
  if (project.verdict != Verdict::changed) return html;
  const std::optional<project::Results> results = resultsOf(project);
  html +=
      "<table><tr><th>value</th><th class=\"n\">expected</th><th class=\"n\">now</th>"
      "<th class=\"n\">difference</th><th class=\"n\">allowed</th></tr>\n";
  for (const Difference& d : project.differences) {
    if (!d.changed) continue;
    const std::string name = placeOf(d, results);
    if (!d.missing.empty()) {
      html += fmt::format("<tr><td>{}</td><td colspan=\"4\">{}</td></tr>\n", name, escapedMarkup(d.missing));
      continue;
    }
    const std::string unit = d.unit == "1" ? "" : " " + d.unit;
    const std::string percent =
        d.expected.value != 0 ? fmt::format("{:+.2g} %", 100 * d.difference() / d.expected.value) : "";
    html += fmt::format(
        "<tr><td>{}</td><td class=\"n\">{}{}</td><td class=\"n\">{}{}</td><td class=\"n\">{}</td>"
        "<td class=\"n\">{:.2g}{}</td></tr>\n",
        name, plot::uncertaintyText(d.expected.value, d.expected.halfWidth()), unit,
        plot::uncertaintyText(d.found.value, d.found.halfWidth()), unit, percent, d.allowed, unit);
  }
  html += "</table>\n";
  if (!results) return html + "<p>The results of this run are gone, so there is nothing to draw.</p>\n";
  for (const project::ExpectedValue& expected : project.baseline->values)
    if (expected.quantity == "points") html += gridsSideBySide(expected, *results);
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
      "a batch like this one raises an alarm in at most {:g} % of the cases; {} values share that. A value is flagged "
      "where it differs by more than is allowed: what chance and the tolerance explain.</p>\n"
      "<table><tr><th>verdict</th><th>project</th><th>changed "
      "inputs</th><th class=\"n\">values</th><th class=\"n\">time</th></tr>\n{}</table>\n{}"
      "</body></html>\n",
      style, countOf(batch, Verdict::passed), batch.projects.size(), countOf(batch, Verdict::changed),
      countOf(batch, Verdict::broken), countOf(batch, Verdict::noBaseline), countOf(batch, Verdict::notRun),
      escapedMarkup(batch.programVersion), 100 * batch.falseAlarms, batch.values, rows, changes);
}

}  // namespace goniolux::pipeline
