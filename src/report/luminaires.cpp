// Room, plan, luminaire schedule and luminaire sheets.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/markup.h"
#include "report/drawings.h"
#include "report/sections.h"

namespace goniolux::report {
namespace {

using core::escapedMarkup;

std::string row(const std::string& name, const std::string& value) {
  return value.empty() ? "" : fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", name, value);
}

std::string heights(const LuminaireType& type, const Words& words) {
  if (type.positions.empty()) return "";
  const auto [low, high] = std::minmax_element(type.positions.begin(), type.positions.end(),
                                               [](const auto& a, const auto& b) { return a.z < b.z; });
  std::string text = words.length(low->z);
  if (high->z - low->z > 0.005) text += " – " + words.length(high->z);
  return text + " " + words.unitName("m");
}

std::string schedule(const Report& report, const Words& words) {
  std::string rows;
  int count = 0;
  double flux = 0, watts = 0;
  bool wattsKnown = true;
  for (const LuminaireType& type : report.luminaires) {
    count += type.count;
    flux += type.count * type.flux_lm;
    watts += type.count * type.watts;
    wattsKnown = wattsKnown && type.watts > 0;
    rows += fmt::format(
        "<tr><td><span class=\"letter\">{}</span></td><td><b>{}</b><br><span class=\"quiet small\">{}</span></td>"
        "<td class=\"n\">{}</td><td class=\"n\">{} lm</td><td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
        escapedMarkup(type.letter), escapedMarkup(type.product.empty() ? type.name : type.product),
        escapedMarkup(type.maker.empty() ? type.file : type.maker), type.count, words.number(type.flux_lm, 0),
        type.watts > 0 ? words.number(type.watts, 1) + " W" : words("not stated"),
        type.watts > 0 ? words.number(type.flux_lm / type.watts, 0) + " lm/W" : "");
  }
  rows += fmt::format(
      "<tr class=\"total\"><td></td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{} lm</td><td class=\"n\">{}</td>"
      "<td class=\"n\">{}</td></tr>\n",
      words("Total"), count, words.number(flux, 0), wattsKnown ? words.number(watts, 1) + " W" : "",
      wattsKnown ? words.number(flux / watts, 0) + " lm/W" : "");
  std::string html = fmt::format(
      "<table><tr><th></th><th>{}</th><th class=\"n\">{}</th><th class=\"n\">{}</th><th class=\"n\">{}</th><th "
      "class=\"n\">{}</th></tr>\n"
      "{}</table>\n",
      words("Luminaire"), words("Count"), words("Flux"), words("Power"), words("Efficacy"), rows);
  if (wattsKnown && report.floorArea_m2)
    html += fmt::format("<p>{}: {} {}</p>\n", words("Connected load"),
                        words.number(words.factor("W/m2") * watts / *report.floorArea_m2, 2), words.unitName("W/m2"));
  return html;
}

std::string positions(const Report& report, const Words& words) {
  std::string rows;
  for (const LuminaireType& type : report.luminaires) {
    std::string list;
    for (const core::Vec3& p : type.positions) {
      if (!list.empty()) list += "; ";
      list += fmt::format("({}, {}, {})", words.length(p.x), words.length(p.y), words.length(p.z));
    }
    rows += fmt::format("<tr><td><span class=\"letter\">{}</span></td><td class=\"small\">{}</td></tr>\n",
                        escapedMarkup(type.letter), list);
  }
  return fmt::format("<h2>{} (x, y, z / {})</h2><table>{}</table>\n", words("Positions"), words.unitName("m"), rows);
}

std::string openingText(const Opening& opening, const Words& words) {
  std::string text = words(opening.shape);
  std::string size;
  for (const auto& [length, direction] : {std::pair(opening.alongC0_m, "C0"), std::pair(opening.alongC90_m, "C90")})
    if (length > 0)
      size += fmt::format("{}{}\u00a0{}\u00a0({})", size.empty() ? "" : " × ", words.length(length),
                          words.unitName("m"), direction);
  if (opening.height_m > 0)
    size += fmt::format("{}{} {} {}", size.empty() ? "" : ", ", words.length(opening.height_m), words.unitName("m"),
                        words("high"));
  return text + (text.empty() || size.empty() ? "" : ", ") + size;
}

std::string sheet(const LuminaireType& type, const Words& words) {
  const auto degrees = [&](const std::optional<double>& c0, const std::optional<double>& c90) {
    if (!c0 || !c90) return std::string();
    if (std::abs(*c0 - *c90) < 0.5) return words.number(*c0, 0) + "°";
    return fmt::format("{}° (C0), {}° (C90)", words.number(*c0, 0), words.number(*c90, 0));
  };
  std::string rows;
  rows += row(words("Manufacturer"), escapedMarkup(type.maker));
  rows += row(words("Catalogue number"), escapedMarkup(type.catalogue));
  rows += row(type.isFile ? words("Photometric file") : words("Distribution"), escapedMarkup(type.file));
  rows += row(words("Count"), std::to_string(type.count));
  rows += row(words("Flux"), words.number(type.flux_lm, 0) + " lm");
  rows += row(words("Power"), type.watts > 0 ? words.number(type.watts, 1) + " W" : words("not stated"));
  if (type.watts > 0) rows += row(words("Efficacy"), words.number(type.flux_lm / type.watts, 0) + " lm/W");
  rows += row(words("Luminous opening"), escapedMarkup(openingText(type.opening, words)));
  if (type.maximum_cd > 0) rows += row(words("Largest intensity"), words.number(type.maximum_cd, 0) + " cd");
  rows += row(words("Beam angle (50 %)"), degrees(type.beamC0_deg, type.beamC90_deg));
  rows += row(words("Field angle (10 %)"), degrees(type.fieldC0_deg, type.fieldC90_deg));
  if (type.polar) rows += row(words("Light downward"), words.number(100 * type.downwardShare, 0) + " %");
  std::string colour = type.cct_K ? words.number(*type.cct_K, 0) + " K" : "";
  if (type.ra) colour += fmt::format("{}R<sub>a</sub> {}", colour.empty() ? "" : ", ", words.number(*type.ra, 0));
  rows += row(words("Colour of light"), colour);
  rows += row(words("Mounting height"), heights(type, words));
  rows += row(words("Maintenance factor"), words.number(type.maintenance, 2));
  if (type.dimming != 1) rows += row(words("Dimming"), words.number(100 * type.dimming, 0) + " %");
  const std::string diagram = type.polar ? polarSvg(*type.polar, words) : "";
  return fmt::format(
      "<h2><span class=\"letter\">{}</span> {}</h2><div class=\"sheet\"><div class=\"left\"><table>{}</table></div>"
      "<div class=\"right\">{}</div></div>\n",
      escapedMarkup(type.letter), escapedMarkup(type.product.empty() ? type.name : type.product), rows, diagram);
}

/// "floor, xmin" as a reader calls the sides of a room.
std::string partsText(const std::string& parts, const Words& words) {
  std::string text;
  for (std::size_t at = 0; at < parts.size();) {
    const std::size_t end = std::min(parts.find(", ", at), parts.size());
    std::string part = parts.substr(at, end - at);
    if (part.size() == 4 && (part.starts_with("x") || part.starts_with("y")))
      part = fmt::format("{} {} {}", words("wall"), part[0], part.substr(1));
    text += (text.empty() ? "" : ", ") + words(part);
    at = end + 2;
  }
  return text;
}

}  // namespace

std::string planSection(const Report& report, const Words& words) {
  std::string html;
  if (report.plan) {
    const std::string drawing = planSvg(*report.plan, words);
    if (!drawing.empty()) html += fmt::format("<figure class=\"drawing\">{}</figure>\n", drawing);
  }
  if (html.empty()) return "";
  if (!report.luminaires.empty()) html += positions(report, words);
  return fmt::format("<section class=\"chapter\"><h1>{}</h1>{}</section>\n", words("Plan with luminaires"), html);
}

std::string luminaireSections(const Report& report, const Words& words) {
  std::string html;
  if (!report.luminaires.empty()) {
    html +=
        fmt::format("<section class=\"chapter\"><h1>{}</h1>{}", words("Luminaire schedule"), schedule(report, words));
    if (!report.surfaces.empty()) {
      std::string rows;
      for (const Surface& s : report.surfaces)
        rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"n\">{} %</td></tr>\n",
                            escapedMarkup(s.object), escapedMarkup(partsText(s.part, words)), escapedMarkup(s.material),
                            words.number(100 * s.reflectance, 0));
      html += fmt::format("<h2>{}</h2>", words("Surfaces"));
      if (report.roomSize)
        html +=
            fmt::format("<p>{}: {} × {} × {} {}{}</p>", words("Size"), words.length(report.roomSize->x),
                        words.length(report.roomSize->y), words.length(report.roomSize->z), words.unitName("m"),
                        report.floorArea_m2 ? fmt::format(", {} {} {}", words("Floor area"),
                                                          words.number(*report.floorArea_m2 * words.factor("m2"), 1),
                                                          words.unitName("m2"))
                                            : "");
      html += fmt::format("<table><tr><th>{}</th><th>{}</th><th>{}</th><th class=\"n\">{}</th></tr>\n{}</table>\n",
                          words("Room"), words("Surface"), words("Material"), words("Reflectance"), rows);
    }
    html += "</section>\n";
    html += fmt::format("<section class=\"chapter\"><h1>{}</h1>", words("Luminaires"));
    for (const LuminaireType& type : report.luminaires) html += sheet(type, words);
    html += "</section>\n";
  }
  return html;
}

}  // namespace goniolux::report
