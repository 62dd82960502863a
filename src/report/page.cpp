// The report as one HTML document: its style, for screen and paper, and its sections in order.
#include <fmt/format.h>

#include "core/markup.h"
#include "plot/base64.h"
#include "report/sections.h"

namespace goniolux::report {
namespace {

using core::escapedMarkup;

// Paper: pages, running heads and page numbers are those of CSS Paged Media Level 3. Screen: the same sections as
// sheets.
constexpr const char* style = R"css(
@page { size: SIZE; margin: 24mm 18mm 22mm 22mm;
  @top-left { content: "PROJECT"; font: 8pt Lato, sans-serif; color: #5a6670; }
  @top-right { content: "TITLE"; font: 8pt Lato, sans-serif; color: #5a6670; }
  @bottom-left { content: "MADE"; font: 8pt Lato, sans-serif; color: #9aa4ac; }
  @bottom-right { content: counter(page) " / " counter(pages); font: 8pt Lato, sans-serif; color: #5a6670; } }
@page cover { margin: 0; @top-left { content: none } @top-right { content: none } @bottom-left { content: none } @bottom-right { content: none } }
* { box-sizing: border-box; }
html { font: 9.5pt/1.45 Lato, "Source Sans 3", "Segoe UI", "DejaVu Sans", sans-serif; color: #1d2329; font-variant-numeric: tabular-nums lining-nums; }
body { margin: 0; }
h1 { font-weight: 300; font-size: 21pt; line-height: 1.15; margin: 0 0 5mm; color: #0f5c73; }
h2 { font-weight: 700; font-size: 11pt; margin: 7mm 0 2mm; break-after: avoid; }
p { margin: 0 0 2.5mm; } .quiet { color: #5a6670; } .small { font-size: 8pt; }
table { border-collapse: collapse; width: 100%; margin: 0 0 4mm; }
th { text-align: left; font-weight: 700; font-size: 8pt; color: #5a6670; border-bottom: 0.8pt solid #1d2329; padding: 1mm 2.5mm 1mm 0; vertical-align: bottom; }
td { border-bottom: 0.4pt solid #dde2e6; padding: 1.3mm 2.5mm 1.3mm 0; vertical-align: top; }
tr { break-inside: avoid; } .n { text-align: right; white-space: nowrap; } tr.total td { border-top: 0.8pt solid #1d2329; border-bottom: none; font-weight: 700; }
.chapter { break-before: page; } figure { margin: 0 0 4mm; break-inside: avoid; } figcaption { color: #5a6670; font-size: 8.5pt; margin-top: 1.5mm; }
img.rendering { max-width: 100%; max-height: 108mm; display: block; }
img.wide, .drawing svg { width: 100%; height: auto; display: block; } .drawing { text-align: center; } .drawing svg { max-height: 205mm; }
.badge { display: inline-block; min-width: 21mm; text-align: center; border-radius: 1mm; color: #fff; font-size: 8pt; font-weight: 700; padding: 0.3mm 2mm; }
.pass { background: #2e7d4f; } .fail { background: #b3372c; } .undecided { background: #b07d12; }
.letter { display: inline-block; width: 6mm; height: 6mm; line-height: 5.4mm; border: 1pt solid #d9921a; border-radius: 50%; text-align: center; font-weight: 700; color: #7a4e06; }
.tiles { display: table; table-layout: fixed; width: TILESmm; border-collapse: separate; border-spacing: 3mm 0; margin: 0 -3mm 4mm; } .tile { display: table-cell; padding: 3mm; background: #f3f6f7; border-top: 2pt solid #d9921a; }
.tile b { display: block; font-weight: 300; font-size: 12pt; line-height: 1.3; white-space: nowrap; } .tile span { color: #5a6670; font-size: 8.5pt; }
.cover { page: cover; position: relative; height: HEIGHTmm; overflow: hidden; background: #fff; }
.cover .hero { height: HEROmm; background: #12222b; overflow: hidden; } .cover .hero img { width: 100%; height: HEROmm; object-fit: cover; display: block; }
.cover .hero .drawing { padding: 18mm; background: #eef2f4; height: HEROmm; } .cover .hero .drawing svg { max-height: 100%; max-width: 100%; width: auto; }
.cover .words { padding: 12mm 18mm 0 22mm; } .cover h1 { font-size: 33pt; color: #1d2329; margin: 0 0 4mm; } .cover .kind { color: #d9921a; font-weight: 700; letter-spacing: 0.12em; text-transform: uppercase; font-size: 9.5pt; margin-bottom: 3mm; }
.cover .tiles { margin-top: 8mm; } .cover .foot { position: absolute; left: 22mm; right: 18mm; bottom: 12mm; color: #5a6670; font-size: 8.5pt; display: flex; justify-content: space-between; }
.sheet { break-inside: avoid; display: flex; margin-bottom: 5mm; } .sheet .left { width: 52%; padding-right: 6mm; } .sheet .right { width: 48%; } .sheet svg { width: 100%; height: auto; }
.sheet td:first-child { color: #5a6670; width: 45%; }
table.values { font-size: VALUESpt; table-layout: fixed; } table.values td, table.values th { text-align: right; padding: 0.5mm 0.8mm; border-bottom: 0.3pt solid #eceff1; } table.values th { color: #5a6670; font-weight: 400; font-size: inherit; white-space: nowrap; } sub { line-height: 0; font-size: 75%; }
.note { border-left: 2pt solid #b3372c; padding: 1mm 0 1mm 4mm; margin-bottom: 4mm; } code { font-family: "DejaVu Sans Mono", monospace; font-size: 7.5pt; word-break: break-all; }
@media screen { body { background: #e4e9ec; } .chapter, .cover { width: WIDTHmm; margin: 8mm auto; background: #fff; box-shadow: 0 1px 6px rgba(0,0,0,.18); } .chapter { padding: 20mm 18mm 16mm 22mm; } }
)css";

void replaceAll(std::string& text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
}

/// A text inside a CSS string.
std::string cssText(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '\\' || c == '<') {
      result += fmt::format("\\{:06x}", static_cast<unsigned char>(c));
    } else if (c == '\n' || c == '\r') {
      result += ' ';
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string imageTag(const Picture& picture, const char* cssClass) {
  return fmt::format("<img class=\"{}\" alt=\"{}\" src=\"data:{};base64,{}\">", cssClass, escapedMarkup(picture.name),
                     picture.mimeType, plot::base64(picture.bytes));
}

std::string htmlOf(const Report& report) {
  const Words words(report.language, report.units);
  std::string css = style;
  // ISO 216 A4, or US letter where feet are in use.
  replaceAll(css, "SIZE", words.imperial() ? "letter" : "A4");
  // Between the margins, and a gap of the tiles on either side.
  replaceAll(css, "TILES", words.imperial() ? "181.9" : "176");
  replaceAll(css, "WIDTH", words.imperial() ? "215.9" : "210");
  replaceAll(css, "HEIGHT", words.imperial() ? "279.2" : "296.8");
  replaceAll(css, "HERO", words.imperial() ? "158" : "172");
  replaceAll(css, "VALUES", "6.6");
  replaceAll(css, "TITLE", cssText(words("Lighting report")));
  replaceAll(css, "MADE", cssText(fmt::format("Goniolux {} · {}", report.results.programVersion, report.date)));
  replaceAll(css, "PROJECT", cssText(report.results.project));
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\"><title>{} – "
      "{}</title><style>{}</style></head>\n"
      "<body>\n{}{}{}{}{}{}{}</body></html>\n",
      words.german() ? "de" : "en", escapedMarkup(report.results.project), words("Lighting report"), css,
      coverSection(report, words), summarySection(report, words), planSection(report, words),
      luminaireSections(report, words), gridSections(report, words), renderingSection(report, words),
      basisSection(report, words));
}

}  // namespace goniolux::report
