// Cover and summary: what a client looks at first.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/markup.h"
#include "report/drawings.h"
#include "report/sections.h"

namespace goniolux::report {
namespace {

using core::escapedMarkup;
using project::GridResult;
using project::RequirementResult;
using Verdict = RequirementResult::Verdict;

std::string tile(const std::string& value, const std::string& what) {
  return fmt::format("<div class=\"tile\"><b>{}</b><span>{}</span></div>", value, escapedMarkup(what));
}

double connectedLoad(const Report& report, bool& known) {
  double watts = 0;
  known = !report.luminaires.empty();
  for (const LuminaireType& type : report.luminaires) {
    watts += type.count * type.watts;
    known = known && type.watts > 0;
  }
  return watts;
}

std::string tiles(const Report& report, const Words& words) {
  std::string html;
  if (!report.results.grids.empty()) {
    const GridResult& grid = report.results.grids.front();
    html += tile(words.estimate(grid.mean, grid.unit) + " " + words.unitName(grid.unit),
                 fmt::format("{}, {}", words("Mean illuminance"), grid.name));
    html += tile(words.estimate(grid.u0, "1"), fmt::format("{}, {}", words("Uniformity U₀"), grid.name));
  }
  bool known = false;
  const double watts = connectedLoad(report, known);
  if (known) {
    std::string text = words.number(watts, watts < 100 ? 1 : 0) + " W";
    if (report.floorArea_m2)
      text = words.number(words.factor("W/m2") * watts / *report.floorArea_m2, words.imperial() ? 2 : 1) + " " +
             words.unitName("W/m2");
    html += tile(text, words("Connected load"));
  }
  if (!report.results.requirements.empty()) {
    const auto& all = report.results.requirements;
    const auto met = std::count_if(all.begin(), all.end(), [](const auto& r) { return r.verdict == Verdict::pass; });
    html += tile(fmt::format("{} {} {}", met, words("of"), all.size()), words("requirements met"));
  }
  return html.empty() ? "" : "<div class=\"tiles\">" + html + "</div>\n";
}

std::string badge(Verdict verdict, const Words& words) {
  switch (verdict) {
    case Verdict::pass:
      return fmt::format("<span class=\"badge pass\">✓ {}</span>", words("met"));
    case Verdict::fail:
      return fmt::format("<span class=\"badge fail\">✗ {}</span>", words("not met"));
    case Verdict::undecided:
      break;
  }
  return fmt::format("<span class=\"badge undecided\">{}</span>", words("undecided"));
}

std::string limitText(const RequirementResult& r, const Words& words) {
  const std::string unit = limitUnit(r.quantity), name = unit.empty() ? "" : " " + words.unitName(unit);
  const auto value = [&](double v) {
    const double converted = v * words.factor(unit);
    const int decimals = converted >= 100 ? 0 : converted == std::round(converted) ? 0 : converted >= 10 ? 1 : 2;
    return words.number(converted, decimals) + name;
  };
  std::string text;
  if (r.minimum) text += words("at least") + " " + value(*r.minimum);
  if (r.maximum) text += (text.empty() ? "" : ", ") + words("at most") + " " + value(*r.maximum);
  return text;
}

/// The clause, with what project::RequirementPreset::reference says of its figures in the reader's language.
std::string clauseText(const std::string& clause, const Words& words) {
  const std::string doubt = " (figures unconfirmed)";
  if (!clause.ends_with(doubt)) return clause;
  return clause.substr(0, clause.size() - doubt.size()) + " (" + words("figures unconfirmed") + ")";
}

std::string requirementTable(const Report& report, const Words& words) {
  const auto& all = report.results.requirements;
  if (all.empty()) return "";
  std::string rows;
  bool undecided = false;
  for (const RequirementResult& r : all) {
    undecided |= r.verdict == Verdict::undecided;
    if (r.quantity.empty()) {  // results of an earlier version: only the sentence
      rows += fmt::format("<tr><td colspan=\"4\">{}</td><td>{}</td></tr>\n", escapedMarkup(r.text),
                          badge(r.verdict, words));
      continue;
    }
    const std::string unit = limitUnit(r.quantity);
    const std::string clause = r.clause.empty() ? ""
                                                : fmt::format("<br><span class=\"quiet small\">{}</span>",
                                                              escapedMarkup(clauseText(r.clause, words)));
    rows +=
        fmt::format("<tr><td>{}{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}{}</td><td>{}</td></tr>\n",
                    escapedMarkup(r.of), clause, words(limitName(r.quantity)), limitText(r, words),
                    r.found ? words.estimate(*r.found, unit.empty() ? "1" : unit) : "–",
                    unit.empty() ? "" : " " + words.unitName(unit), badge(r.verdict, words));
  }
  return fmt::format(
      "<h2>{}</h2><table><tr><th>{}</th><th>{}</th><th class=\"n\">{}</th><th class=\"n\">{}</th><th>{}</th></tr>\n"
      "{}</table>\n{}",
      words("Requirements"), words("Area"), words("Quantity"), words("Required"), words("Calculated"), words("Verdict"),
      rows,
      undecided ? fmt::format("<p class=\"quiet small\">{}</p>",
                              words("A requirement is undecided where its limit lies inside the interval "
                                    "of the calculated value: a finer accuracy decides it."))
                : "");
}

/// The luminaires with the largest shares of the glare sum.
std::string largestSources(const project::ObserverResult& observer, const Words& words) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, observer.sources.size()); ++i)
    text += fmt::format("{}{} {} %", text.empty() ? "" : ", ", observer.sources[i].luminaire,
                        words.number(100 * observer.sources[i].share, 0));
  return text.empty() ? "–" : text;
}

std::string gridTable(const Report& report, const Words& words) {
  std::string rows;
  for (const GridResult& grid : report.results.grids) {
    const std::string unit = " " + words.unitName(grid.unit);
    rows += fmt::format(
        "<tr><td>{}<br><span class=\"quiet small\">{}</span></td><td class=\"n\">{}{}</td><td class=\"n\">{}{}</td>"
        "<td class=\"n\">{}{}</td><td class=\"n\">{}</td></tr>\n",
        escapedMarkup(grid.name), escapedMarkup(words(grid.quantity)), words.estimate(grid.mean, grid.unit), unit,
        words.estimate(grid.min, grid.unit), unit, words.estimate(grid.max, grid.unit), unit,
        words.estimate(grid.u0, "1"));
  }
  std::string html;
  if (!rows.empty())
    html = fmt::format(
        "<h2>{}</h2><table><tr><th>{}</th><th class=\"n\">{}</th><th class=\"n\">{}</th><th class=\"n\">{}</th>"
        "<th class=\"n\">U₀</th></tr>\n{}</table>\n",
        words("Illuminance"), words("Area"), words("Mean"), words("Minimum"), words("Maximum"), rows);
  rows.clear();
  for (const project::ObserverResult& observer : report.results.observers)
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"n\">{}</td></tr>\n",
                        escapedMarkup(observer.name), words(limitName(observer.quantity)),
                        escapedMarkup(largestSources(observer, words)), words.estimate(observer.value, "1"));
  if (!rows.empty())
    html += fmt::format(
        "<h2>{0}</h2><table><tr><th>{0}</th><th>{1}</th><th>{2}</th><th class=\"n\">{3}</th></tr>\n{4}</table>\n",
        words("Observer"), words("Quantity"), words("Glares most"), words("Value"), rows);
  return html;
}

}  // namespace

std::string coverSection(const Report& report, const Words& words) {
  std::string hero;
  if (!report.renderings.empty())
    hero = imageTag(report.renderings.front(), "hero");
  else if (report.plan)
    hero = fmt::format("<div class=\"drawing\">{}</div>", planSvg(*report.plan, words));
  std::string size;
  if (report.roomSize)
    size = fmt::format("{} × {} × {} {}", words.length(report.roomSize->x), words.length(report.roomSize->y),
                       words.length(report.roomSize->z), words.unitName("m"));
  return fmt::format(
      "<section class=\"cover\"><div class=\"hero\">{}</div><div class=\"words\"><div class=\"kind\">{}</div>"
      "<h1>{}</h1><p class=\"quiet\">{}</p>{}</div>"
      "<div class=\"foot\"><span>{}</span><span>Goniolux {}</span></div></section>\n",
      hero, words("Lighting report"), escapedMarkup(report.results.project), size, tiles(report, words),
      escapedMarkup(report.date), escapedMarkup(report.results.programVersion));
}

std::string contributionSection(const Report& report, const Words& words) {
  if (report.contributions.empty()) return "";
  const auto& grids = report.results.grids;
  std::string head = fmt::format("<th>{}</th><th class=\"n\">{}</th>", words("Group"), words("Level"));
  for (const GridResult& grid : grids) head += fmt::format("<th class=\"n\">{}</th>", escapedMarkup(grid.name));
  std::string rows;
  for (const Contribution& c : report.contributions) {
    rows +=
        fmt::format("<tr><td>{}</td><td class=\"n\">{} %</td>", escapedMarkup(c.group), words.number(100 * c.level, 0));
    for (std::size_t i = 0; i < grids.size(); ++i) {
      const double share = grids[i].mean.value > 0 ? c.means[i].value / grids[i].mean.value : 0;
      rows += fmt::format("<td class=\"n\">{} {}<br><span class=\"quiet small\">{} %</span></td>",
                          words.estimate(c.means[i], grids[i].unit), words.unitName(grids[i].unit),
                          words.number(100 * share, 0));
    }
    rows += "</tr>\n";
  }
  return fmt::format("<h2>{}</h2><table><tr>{}</tr>\n{}</table>\n", words("Contribution of each group of luminaires"),
                     head, rows);
}

std::string summarySection(const Report& report, const Words& words) {
  std::string html = fmt::format("<section class=\"chapter\"><h1>{}</h1>\n", words("Results at a glance"));
  for (const std::string& remark : report.remarks)
    html += fmt::format("<p class=\"note\"><b>{}:</b> {}</p>\n", words("Please note"),
                        escapedMarkup(words.sentence(remark)));
  if (!report.results.reached)
    html += fmt::format("<p class=\"note\"><b>{}:</b> {}</p>\n", words("The accuracy asked for was not reached"),
                        escapedMarkup(report.results.reachedText));
  if (!report.results.lightingScene.empty())
    html += fmt::format("<p>{}: {}</p>", words("Lighting scene"), escapedMarkup(report.results.lightingScene));
  html += requirementTable(report, words) + gridTable(report, words) + contributionSection(report, words);
  html +=
      fmt::format("<p class=\"quiet small\">{}</p></section>\n",
                  words("Every number comes with an interval: the exact answer for the room as it is described lies "
                        "in value ± half-width at the confidence stated. Differences between the room as described "
                        "and the room as built are not part of it."));
  return html;
}

}  // namespace goniolux::report
