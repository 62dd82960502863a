#include "validation/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace goniolux::validation {
namespace {

std::string percent(double share) {
  std::string text = fmt::format("{:.3f} %", 100 * share);
  return text;
}

std::string signedPercent(double share) {
  const std::string text = fmt::format("{:+.3f} %", 100 * share);
  return text == "-0.000 %" || text == "+0.000 %" ? "0.000 %" : text;
}

// Two digits of the half-width, and the value to the same place.
std::string withInterval(double value, double halfWidth) {
  if (!(halfWidth > 0)) return fmt::format("{:.6g}", value);
  const int place = std::clamp(1 - static_cast<int>(std::floor(std::log10(halfWidth))), 0, 9);
  return fmt::format("{:.{}f} ± {:.{}f}", value, place, halfWidth, place);
}

std::string word(NumberVerdict verdict) {
  switch (verdict) {
    case NumberVerdict::right:
      return "right";
    case NumberVerdict::outside:
      return "outside 95 %";
    case NumberVerdict::wrong:
      return "**wrong**";
  }
  return "";
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, '|');) cells.push_back(cell);
  return cells;
}

// "12.3 ± 0.4".
bool readInterval(const std::string& cell, double& value, double& halfWidth) {
  const std::string sign = "±";
  const std::size_t at = cell.find(sign);
  if (at == std::string::npos) return false;
  try {
    value = std::stod(cell.substr(0, at));
    halfWidth = std::stod(cell.substr(at + sign.size()));
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

bool sameRow(const std::string& written, const std::string& line) {
  const auto a = cellsOf(written), b = cellsOf(line);
  if (a.size() != b.size() || a.size() < 6) return false;
  if (a.size() == 8 && a[5].find("±") != std::string::npos) {  // summary of a case with intervals
    for (const std::size_t same : {1u, 2u, 3u, 6u})
      if (a[same] != b[same]) return false;
    return true;
  }
  double value = 0, halfWidth = 0, other = 0, otherWidth = 0;
  if (!readInterval(a[3], value, halfWidth) || !readInterval(b[3], other, otherWidth)) return false;
  return a[1] == b[1] && a[2] == b[2] && std::abs(value - other) <= halfWidth + otherWidth;
}

}  // namespace

PagePart partOf(const Case& of, const std::vector<Number>& numbers) {
  const Verdict verdict = verdictOf(numbers, of);
  PagePart part;
  part.id = of.id;
  std::string outcome = verdict.passed() ? "right" : "**wrong**";
  if (verdict.outside > 0) outcome += fmt::format(" ({} of {} outside their 95 %)", verdict.outside, numbers.size());
  if (verdict.wrong > 0) outcome += fmt::format(" ({} of {})", verdict.wrong, numbers.size());
  part.summary = fmt::format("| {} | {} | {} | {} | {} | {} |", of.id, of.title, numbers.size(),
                             percent(verdict.largest), verdict.byChance ? "± " + percent(verdict.widest) : "none",
                             verdict.byChance && verdict.passed() ? "right" : outcome);
  part.summary += fmt::format(" {} |", of.others.empty() ? "–" : of.others);
  std::string& table = part.table;
  table = fmt::format("### {} {}\n\n{}{}. Reference: {}. Asked: {}.\n\n", of.id, of.title, of.scene,
                      of.unit.empty() ? "" : fmt::format("; in {}", of.unit), of.source,
                      verdict.byChance ? fmt::format("an interval of at most ± {:g} %", 100 * of.tolerance)
                                       : fmt::format("{:g} %", 100 * of.tolerance) +
                                             (of.scale > 0 ? fmt::format(" (of {:g} at least)", of.scale) : ""));
  if (!of.knownDefect.empty()) table += fmt::format("A known defect: {}.\n\n", of.knownDefect);
  table += "| | reference | Goniolux | off by | |\n|---|---|---|---|---|\n";
  for (const Number& number : numbers)
    table += fmt::format("| {} | {:.6g} | {} | {} | {} |\n", number.what, number.reference,
                         withInterval(number.ours, number.halfWidth), signedPercent(deviationOf(number, of)),
                         word(verdictOf(number, of)));
  return part;
}

PagePart partNotCalculated(const Case& of) {
  return {of.id,
          fmt::format("| {} | {} | – | – | – | not on this page yet: `script/validation` | {} |", of.id, of.title,
                      of.others.empty() ? "–" : of.others),
          ""};
}

PagePart partFrom(const std::string& page, const std::string& id) {
  PagePart part;
  part.id = id;
  const std::string row = fmt::format("| {} |", id), heading = fmt::format("### {} ", id);
  bool inside = false;
  for (const std::string& line : linesOf(page)) {
    if (line.starts_with(row) && part.summary.empty()) part.summary = line;
    if (line.starts_with("##")) inside = line.starts_with(heading);
    if (inside) part.table += line + "\n";
  }
  while (part.table.ends_with("\n\n")) part.table.pop_back();
  return part;
}

std::string validationPage(const std::vector<Section>& sections, const std::vector<std::vector<PagePart>>& parts) {
  std::string page =
      "# Validation\n\n"
      "Numbers of Goniolux beside numbers that do not come from it: closed forms, published tables, other programs. "
      "This page is written by the test program `test_validation` (`GONIOLUX_UPDATE_PAGES=1 script/validation`), and "
      "every test run calculates it anew and compares.\n\n"
      "*Off by*: relative to the reference. *Interval*: the widest 95 % half-width of a case's numbers, relative "
      "likewise; none: calculated without chance. A number with an interval is right when the interval, with the "
      "reference's own uncertainty, holds the reference: of twenty such numbers one lies outside by chance. It is "
      "wrong "
      "when twice the interval does not hold it, or when the interval is wider than asked. What other tools reach is "
      "what "
      "their makers or testers have published, in the words of the case.\n\n"
      "Not here: daylight. Skies, sun and openings (CIE 171, 5.9 to 5.14, and the part of 5.4 about openings) are "
      "outside "
      "what Goniolux does, as are the measured scenes of CIE 171, section 4, whose tables are not public.\n\n"
      "Most cases are calculated by every run of the tests, in about 70 s of CPU time. Seven (1.7x, 1.7q, 3.1x, 3.1q, "
      "3.2x and 3.3x, white rooms, and 7.2f) take from seconds to many minutes each: `script/validation` calculates "
      "them "
      "as well, and their rows stand here as it left them.\n\n"
      "| | case | numbers | largest deviation | interval | verdict | other tools |\n|---|---|---|---|---|---|---|\n";
  for (const auto& section : parts)
    for (const PagePart& part : section) page += part.summary + "\n";
  for (std::size_t s = 0; s < sections.size(); ++s) {
    page += fmt::format("\n## {}\n\n{}\n", sections[s].title, sections[s].introduction);
    for (const PagePart& part : parts[s])
      if (!part.table.empty()) page += "\n" + part.table;
  }
  return page;
}

std::string firstDifference(const std::string& written, const std::string& page) {
  const auto a = linesOf(written), b = linesOf(page);
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    if (i >= a.size() || i >= b.size()) return fmt::format("line {}: one of the pages ends", i + 1);
    if (a[i] != b[i] && !sameRow(a[i], b[i]))
      return fmt::format("line {}:\n  is:        {}\n  should be: {}", i + 1, b[i], a[i]);
  }
  return "";
}

}  // namespace goniolux::validation
