// One page per grid: map, figures with their intervals, table of values; then renderings; then how it was made.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

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

/// Along which axis an edge of the grid runs, and where its points lie on it: a coordinate of the room where the edge
/// runs along one, else the distance from the first point.
struct Edge {
  std::string name;
  std::function<double(const core::Vec3&)> at;
};

Edge edgeOf(const core::Vec3& first, const core::Vec3& last, const char* otherwise) {
  const core::Vec3 along = last - first;
  const double length = glm::length(along);
  constexpr std::array names{"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis)
    if (length > 0 && std::abs(along[axis]) > (1 - 1e-9) * length)
      return {names[static_cast<std::size_t>(axis)], [axis](const core::Vec3& p) { return p[axis]; }};
  return {otherwise, [first](const core::Vec3& p) { return glm::length(p - first); }};
}

std::string shownText(const GridResult& grid, int du, int dv, const Words& words) {
  const std::string all = fmt::format("{} {}.csv", words("all points are in"), project::fileNameFor(grid.name));
  const auto count = fmt::format("{} × {}", (*grid.counts)[0], (*grid.counts)[1]);
  if (words.german())
    return fmt::format("{} Punkte; gezeigt: jede{} Spalte, jede{} Zeile; {}", count,
                       du > 1 ? fmt::format(" {}.", du) : "", dv > 1 ? fmt::format(" {}.", dv) : "", all);
  const auto every = [](int n, const char* what) {
    return n == 1 ? fmt::format("every {}", what)
                  : fmt::format("every {}{} {}", n,
                                n == 2   ? "nd"
                                : n == 3 ? "rd"
                                         : "th",
                                what);
  };
  return fmt::format("{} points; shown: {}, {}; {}", count, every(du, "column"), every(dv, "row"), all);
}

/// The values as they lie in the plane, the v axis upward, each under and beside its coordinates. A large grid is
/// thinned out, and says so.
std::string valueTable(const GridResult& grid, const Words& words) {
  if (!grid.counts || grid.points.empty()) return "";
  const int nu = (*grid.counts)[0], nv = (*grid.counts)[1];
  constexpr int mostColumns = 16, mostRows = 18;
  const int du = (nu + mostColumns - 1) / mostColumns, dv = (nv + mostRows - 1) / mostRows;
  const auto pointAt = [&](int i, int j) { return grid.points[static_cast<std::size_t>(j * nu + i)]; };
  const Edge u = edgeOf(pointAt(0, 0), pointAt(nu - 1, 0), "u"), v = edgeOf(pointAt(0, 0), pointAt(0, nv - 1), "v");
  std::string rows;
  for (int j = (nv - 1) / dv * dv; j >= 0; j -= dv) {
    rows += fmt::format("<tr><th>{}</th>", words.length(v.at(pointAt(0, j))));
    for (int i = 0; i < nu; i += du) {
      const double value = grid.values[static_cast<std::size_t>(j * nu + i)];
      rows += fmt::format("<td>{}</td>", std::isfinite(value) ? words.value(value, grid.unit) : "×");
    }
    rows += "</tr>\n";
  }
  rows += fmt::format("<tr><th>{}, {} / {}</th>", v.name, u.name, words.unitName("m"));
  for (int i = 0; i < nu; i += du) rows += fmt::format("<th>{}</th>", words.length(u.at(pointAt(i, 0))));
  rows += "</tr>\n";
  const std::string note = du > 1 || dv > 1 ? shownText(grid, du, dv, words) : "";
  return fmt::format("<h2>{} / {}</h2><table class=\"values\">{}</table><p class=\"quiet small\">{}</p>\n",
                     words("Value table"), words.unitName(grid.unit), rows, note);
}

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("<tr><td style=\"width:35%\" class=\"quiet\">{}</td><td>{}</td></tr>\n", name, value);
}

std::string settingText(const core::Value& value) {
  if (value.isString()) return value.string();
  if (value.isNumber()) return fmt::format("{:g}", value.number());
  if (value.isBoolean()) return value.boolean() ? "true" : "false";
  return "";
}

/// "grids ± 2 %, images ± 10 %, colour ΔE00 1".
std::string accuracyText(const core::Value& asked, const Words& words) {
  std::string text;
  const auto share = [&](const char* key, const std::string& name) {
    if (const core::Value* value = asked.find(key); value && value->isNumber())
      text += fmt::format("{}{} ± {} %", text.empty() ? "" : ", ", name, words.number(100 * value->number(), 0));
  };
  share("grid", words("grids"));
  share("u0", "U₀");
  share("image", words("images"));
  if (const core::Value* value = asked.find("colour_de"); value && value->isNumber())
    text += fmt::format(", {} ΔE₀₀ {}", words("colour"), words.number(value->number(), 0));
  return text;
}

std::string settingRows(const project::Results& results, const Words& words) {
  std::string rows = row(words("Confidence"), words.number(100 * results.confidence, 0) + " %");
  if (!results.settingsUsed.isObject()) return rows;
  for (const auto& [key, value] : results.settingsUsed.object()) {
    std::string name = key == "solver"             ? words("Method")
                       : key == "spectral_scheme"  ? words("Spectral sampling")
                       : key == "spectral_samples" ? words("Wavelengths")
                       : key == "accuracy"         ? words("Accuracy asked for")
                                                   : key;
    std::replace(name.begin(), name.end(), '_', ' ');
    const std::string text = value.isObject() ? accuracyText(value, words) : settingText(value);
    if (!text.empty()) rows += row(escapedMarkup(name), escapedMarkup(text));
  }
  return rows;
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
  const std::string settings = settingRows(results, words);
  std::string leftOut;
  for (const std::string& sentence : results.leftOut)
    leftOut += fmt::format("<li>{}</li>", escapedMarkup(words.sentence(sentence)));
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
