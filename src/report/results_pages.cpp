// One page per grid: map, figures with their intervals, table of values; then renderings; then how it was made.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/markup.h"
#include "report/sections.h"

namespace goniolux::report {
namespace {

using core::escapedMarkup;
using project::GridResult;

std::string figures(const GridResult& grid, const Words& words) {
  const std::string unit = " " + words.unitName(grid.unit);
  const auto tile = [&](const core::Estimate& e, const std::string& of, const std::string& name) {
    return fmt::format("<div class=\"tile\"><b>{}{}</b><span>{}</span></div>", words.estimate(e, of),
                       of == "1" ? "" : unit, words(name));
  };
  return "<div class=\"tiles\">" + tile(grid.mean, grid.unit, "Mean") + tile(grid.min, grid.unit, "Minimum") +
         tile(grid.max, grid.unit, "Maximum") + tile(grid.u0, "1", "Uniformity U₀") + "</div>\n";
}

/// The values as they lie in the plane, the v axis upward. A large grid is thinned out, and says so.
std::string valueTable(const GridResult& grid, const Words& words) {
  if (!grid.counts) return "";
  const int nu = (*grid.counts)[0], nv = (*grid.counts)[1];
  constexpr int mostColumns = 16, mostRows = 18;
  const int du = (nu + mostColumns - 1) / mostColumns, dv = (nv + mostRows - 1) / mostRows;
  std::string rows;
  for (int j = (nv - 1) / dv * dv; j >= 0; j -= dv) {
    rows += "<tr>";
    for (int i = 0; i < nu; i += du) {
      const double value = grid.values[static_cast<std::size_t>(j * nu + i)];
      rows += fmt::format("<td>{}</td>", std::isfinite(value) ? words.value(value, grid.unit) : "×");
    }
    rows += "</tr>\n";
  }
  std::string note = words("Every value stands at its point");
  if (du > 1 || dv > 1)
    note = fmt::format("{} × {} {}; {} {}. {}, {}. {}; {} {}.csv", nu, nv, words("Points"), words("shown: every"), du,
                       words("column"), dv, words("row"), words("all points are in"), project::fileNameFor(grid.name));
  return fmt::format("<h2>{} / {}</h2><table class=\"values\">{}</table><p class=\"quiet small\">{}</p>\n",
                     words("Value table"), words.unitName(grid.unit), rows, note);
}

std::string settingText(const core::Value& value) {
  if (value.isString()) return value.string();
  if (value.isNumber()) return fmt::format("{:g}", value.number());
  if (value.isBoolean()) return value.boolean() ? "true" : "false";
  if (!value.isObject()) return "";
  std::string text;
  for (const auto& [key, member] : value.object()) text += (text.empty() ? "" : ", ") + key + " " + settingText(member);
  return text;
}

}  // namespace

std::string gridSections(const Report& report, const Words& words) {
  std::string html;
  for (std::size_t i = 0; i < report.results.grids.size(); ++i) {
    const GridResult& grid = report.results.grids[i];
    html += fmt::format("<section class=\"chapter\"><h1>{}</h1><p class=\"quiet\">{}</p>{}", escapedMarkup(grid.name),
                        escapedMarkup(words(grid.quantity)), figures(grid, words));
    if (i < report.maps.size() && report.maps[i])
      html += fmt::format("<figure>{}</figure>\n", imageTag(*report.maps[i], "wide"));
    html += valueTable(grid, words) + "</section>\n";
  }
  return html;
}

std::string renderingSection(const Report& report, const Words& words) {
  if (report.renderings.empty()) return "";
  std::string html = fmt::format("<section class=\"chapter\"><h1>{}</h1><p class=\"quiet\">{}</p>", words("Renderings"),
                                 words("Calculated luminance, shown for a monitor"));
  for (const Picture& picture : report.renderings)
    html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", imageTag(picture, "rendering"),
                        escapedMarkup(picture.name));
  return html + "</section>\n";
}

std::string basisSection(const Report& report, const Words& words) {
  const project::Results& results = report.results;
  const auto row = [](const std::string& name, const std::string& value) {
    return fmt::format("<tr><td style=\"width:35%\" class=\"quiet\">{}</td><td>{}</td></tr>\n", name, value);
  };
  std::string settings = row(words("Confidence"), words.number(100 * results.confidence, 0) + " %");
  if (results.settingsUsed.isObject())
    for (const auto& [key, value] : results.settingsUsed.object()) {
      std::string name = key;
      std::replace(name.begin(), name.end(), '_', ' ');
      if (const std::string text = settingText(value); !text.empty())
        settings += row(escapedMarkup(name), escapedMarkup(text));
    }
  std::string leftOut;
  for (const std::string& sentence : results.leftOut) leftOut += fmt::format("<li>{}</li>", escapedMarkup(sentence));
  std::string made = row(words("Program"), "Goniolux " + escapedMarkup(results.programVersion));
  made += row(words("Seed"), std::to_string(results.seed));
  made += row(words("Calculation time"), words.number(results.wallTime_s, 1) + " s");
  made += row(words("Light paths"), words.number(1e-6 * static_cast<double>(results.rays), 2) + " × 10⁶");
  made += row(words("Project hash"), "<code>" + escapedMarkup(results.projectHash) + "</code>");
  std::string inputs;
  for (const project::InputFile& input : results.inputs)
    inputs += fmt::format("<tr><td>{}</td><td><code>{}</code></td></tr>\n", escapedMarkup(input.path), input.sha256);
  std::string html = fmt::format("<section class=\"chapter\"><h1>{}</h1><p>{}</p><h2>{}</h2><table>{}</table>",
                                 words("How it was calculated"),
                                 words("Every number comes with an interval: the exact answer for the room as it is "
                                       "described lies in value ± half-width at the confidence stated. Differences "
                                       "between the room as described and the room as built are not part of it."),
                                 words("Settings"), settings);
  html += fmt::format("<h2>{}</h2><ul>{}</ul>", words("Left out"), leftOut.empty() ? "<li>–</li>" : leftOut);
  html += fmt::format("<h2>{}</h2><table>{}</table>", words("Provenance"), made);
  if (!inputs.empty())
    html += fmt::format("<h2>{}</h2><table><tr><th>{}</th><th>SHA-256</th></tr>{}</table>", words("Inputs"),
                        words("File"), inputs);
  if (report.speedChart)
    html += fmt::format("<h2>{}</h2><figure>{}<figcaption>{}</figcaption></figure>", words("Speed against accuracy"),
                        imageTag(*report.speedChart, "wide"),
                        words("Error against calculation time of this project, held against a long reference"));
  return html + "</section>\n";
}

}  // namespace goniolux::report
