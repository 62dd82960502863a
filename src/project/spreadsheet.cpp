#include "project/spreadsheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "core/markup.h"
#include "core/zip.h"

namespace goniolux::project {
namespace {

using core::Estimate;

constexpr const char* mimeType = "application/vnd.oasis.opendocument.spreadsheet";

constexpr int mostDecimals = 6;

/// So many that the half-width is seen with two digits.
int decimalsFor(double halfWidth) {
  if (!(halfWidth > 0) || !std::isfinite(halfWidth)) return 3;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(halfWidth))), 0, mostDecimals);
}

/// A sheet as it grows, row by row.
class Sheet {
 public:
  /// `wide`: columns that hold words, from the left; the style of the columns of numbers.
  Sheet(const std::string& name, int wide, const char* numbers = "narrow") {
    xml_ = fmt::format("<table:table table:name=\"{}\">", core::escapedMarkup(name));
    if (wide > 0) xml_ += column("wide", wide);
    xml_ += column(numbers, 40);
  }
  Sheet& text(const std::string& value, const char* style = "") {
    row_ +=
        fmt::format("<table:table-cell{} office:value-type=\"string\"><text:p>{}</text:p></table:table-cell>",
                    *style == '\0' ? "" : fmt::format(" table:style-name=\"{}\"", style), core::escapedMarkup(value));
    return *this;
  }
  /// Shown with so many decimals, kept with all its digits. A number that does not exist (a point inside a solid) is an
  /// empty cell.
  Sheet& number(double value, int decimals) {
    row_ += std::isfinite(value) ? fmt::format(
                                       "<table:table-cell table:style-name=\"d{1}\" office:value-type=\"float\" "
                                       "office:value=\"{0}\"><text:p>{0:.{1}f}</text:p></table:table-cell>",
                                       value, decimals)
                                 : "<table:table-cell/>";
    return *this;
  }
  Sheet& estimate(const Estimate& e) {
    const int decimals = decimalsFor(e.halfWidth());
    return number(e.value, decimals).number(e.halfWidth(), decimals);
  }
  Sheet& limit(const std::optional<double>& value) {
    return number(value.value_or(NAN), value && *value == std::round(*value) ? 0 : 2);
  }
  Sheet& words(std::initializer_list<std::string> names) {
    for (const std::string& name : names) text(name, "header");
    return *this;
  }
  /// Heads of columns of numbers.
  Sheet& numbers(std::initializer_list<std::string> names) {
    for (const std::string& name : names) text(name, "number-header");
    return *this;
  }
  Sheet& end() {
    xml_ += "<table:table-row>" + (row_.empty() ? std::string("<table:table-cell/>") : row_) + "</table:table-row>\n";
    row_.clear();
    return *this;
  }
  [[nodiscard]] std::string xml() const { return xml_ + "</table:table>\n"; }

 private:
  static std::string column(const char* style, int count) {
    return fmt::format("<table:table-column table:style-name=\"{}\" table:number-columns-repeated=\"{}\"/>", style,
                       count);
  }
  std::string xml_, row_;
};

/// Sheet names that every program takes: at most 31 bytes, without the characters of references, each once.
class SheetNames {
 public:
  std::string take(const std::string& wanted, const std::string& suffix = "") {
    std::string name = wanted;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return std::string("[]:*?/\\'").find(c) != std::string::npos; }, ' ');
    for (int i = 1;; ++i) {
      const std::string tail = suffix + (i > 1 ? fmt::format(" {}", i) : "");
      std::string head = name.substr(0, longest - tail.size());
      // A letter of several bytes is not cut in two.
      if (head.size() < name.size())
        while (!head.empty() && (static_cast<unsigned char>(name[head.size()]) & 0xc0) == 0x80) head.pop_back();
      if (head.empty()) head = "grid";
      if (taken_.insert(head + tail).second) return head + tail;
    }
  }

 private:
  static constexpr std::size_t longest = 31;
  std::set<std::string> taken_;
};

std::string inUnit(const std::string& name, const std::string& unit) {
  return unit.empty() || unit == "1" ? name : name + " / " + unit;
}

/// Names of limits as they are read, not as they are written in a project.
std::string quantityName(const std::string& key) {
  if (key == "mean_lx") return "mean / lx";
  if (key == "min_lx") return "minimum / lx";
  if (key == "max_lx") return "maximum / lx";
  if (key == "u0") return "U0";
  if (key == "ud") return "minimum / maximum";
  if (key == "ugr") return "UGR";
  if (key == "ra") return "Ra";
  return key;
}

std::string summary(const Results& results, const std::string& name) {
  Sheet sheet(name, 2);
  sheet.words({results.project}).end();
  sheet.text(fmt::format("half-widths (±) at {:g} % confidence", 100 * results.confidence)).end().end();
  sheet.words({"Grid", "Quantity", "Unit"}).numbers({"Mean", "±", "Minimum", "±", "Maximum", "±", "U0", "±"}).end();
  for (const GridResult& grid : results.grids)
    sheet.text(grid.name)
        .text(grid.quantity)
        .text(grid.unit)
        .estimate(grid.mean)
        .estimate(grid.min)
        .estimate(grid.max)
        .estimate(grid.u0)
        .end();
  if (!results.observers.empty()) sheet.end().words({"Observer", "Quantity"}).numbers({"Value", "±"}).end();
  for (const ObserverResult& observer : results.observers)
    sheet.text(observer.name).text(quantityName(observer.quantity)).estimate(observer.value).end();
  if (!results.requirements.empty())
    sheet.end()
        .words({"Requirement", "Quantity"})
        .numbers({"At least", "At most", "Calculated", "±"})
        .words({"Verdict", "Clause"})
        .end();
  for (const RequirementResult& r : results.requirements) {
    sheet.text(r.of.empty() ? r.text : r.of).text(quantityName(r.quantity));
    sheet.limit(r.minimum).limit(r.maximum).estimate(r.found.value_or(Estimate{NAN, NAN, {}}));
    sheet.text(wordFor(r.verdict)).text(r.clause).end();
  }
  return sheet.xml();
}

std::string pointList(const GridResult& grid, const std::string& name) {
  Sheet sheet(name, 0, "medium");
  sheet.numbers({"x / m", "y / m", "z / m", inUnit(grid.quantity, grid.unit), inUnit("±", grid.unit)}).end();
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    const int decimals = decimalsFor(grid.halfWidths[i]);
    for (const double coordinate : {grid.points[i].x, grid.points[i].y, grid.points[i].z}) sheet.number(coordinate, 3);
    sheet.number(grid.values[i], decimals).number(grid.halfWidths[i], decimals).end();
  }
  return sheet.xml();
}

/// Distances along the edges from the grid's first point, as a reader of a plan counts them.
std::string inThePlane(const GridResult& grid, const std::string& name) {
  Sheet sheet(name, 0);
  const std::size_t nu = static_cast<std::size_t>((*grid.counts)[0]), nv = static_cast<std::size_t>((*grid.counts)[1]);
  sheet.text(inUnit(grid.quantity, grid.unit) + "; right: along u / m, up: along v / m", "header").end();
  double finest = INFINITY;
  for (const double halfWidth : grid.halfWidths)
    if (halfWidth > 0) finest = std::min(finest, halfWidth);
  const int decimals = std::max(0, decimalsFor(finest) - 1);
  for (std::size_t j = nv; j-- > 0;) {
    sheet.number(glm::length(grid.points[j * nu] - grid.points[0]), 2);
    for (std::size_t i = 0; i < nu; ++i) sheet.number(grid.values[j * nu + i], decimals);
    sheet.end();
  }
  sheet.text("v, u", "number-header");
  for (std::size_t i = 0; i < nu; ++i) sheet.number(glm::length(grid.points[i] - grid.points[0]), 2);
  return sheet.end().xml();
}

std::string howMade(const Results& results, const std::string& name) {
  Sheet sheet(name, 2);
  sheet.text("Program").text("Goniolux " + results.programVersion).end();
  sheet.text("Project hash").text(results.projectHash).end();
  sheet.text("Seed").text(std::to_string(results.seed)).end();
  if (!results.lightingScene.empty()) sheet.text("Lighting scene").text(results.lightingScene).end();
  if (!results.reachedText.empty()) sheet.text("Accuracy").text(results.reachedText).end();
  for (const std::string& sentence : results.leftOut) sheet.text("Left out").text(sentence).end();
  for (const InputFile& input : results.inputs) sheet.text("Input").text(input.path).text(input.sha256).end();
  return sheet.xml();
}

/// Heads, widths of columns, and a style for each number of decimals.
std::string cellStyles() {
  std::string xml =
      "<style:style style:name=\"header\" style:family=\"table-cell\"><style:text-properties fo:font-weight=\"bold\"/>"
      "</style:style>\n"
      "<style:style style:name=\"number-header\" style:family=\"table-cell\"><style:table-cell-properties "
      "style:text-align-source=\"fix\"/><style:paragraph-properties fo:text-align=\"end\"/><style:text-properties "
      "fo:font-weight=\"bold\"/></style:style>\n";
  for (const auto& [name, width] :
       {std::pair("wide", "5cm"), std::pair("medium", "3.4cm"), std::pair("narrow", "2.3cm")})
    xml += fmt::format(
        "<style:style style:name=\"{}\" style:family=\"table-column\"><style:table-column-properties "
        "style:column-width=\"{}\"/></style:style>\n",
        name, width);
  for (int decimals = 0; decimals <= mostDecimals; ++decimals)
    xml += fmt::format(
        "<number:number-style style:name=\"decimals{0}\"><number:number number:decimal-places=\"{0}\" "
        "number:min-integer-digits=\"1\"/></number:number-style>"
        "<style:style style:name=\"d{0}\" style:family=\"table-cell\" style:data-style-name=\"decimals{0}\"/>\n",
        decimals);
  return xml;
}

}  // namespace

std::string toSpreadsheet(const Results& results) {
  SheetNames names;
  std::string sheets = summary(results, names.take("Summary"));
  for (const GridResult& grid : results.grids) {
    sheets += pointList(grid, names.take(grid.name));
    if (grid.counts && !grid.points.empty()) sheets += inThePlane(grid, names.take(grid.name, " plan"));
  }
  sheets += howMade(results, names.take("How it was made"));
  constexpr const char* spaces =
      "xmlns:office=\"urn:oasis:names:tc:opendocument:xmlns:office:1.0\" "
      "xmlns:style=\"urn:oasis:names:tc:opendocument:xmlns:style:1.0\" "
      "xmlns:table=\"urn:oasis:names:tc:opendocument:xmlns:table:1.0\" "
      "xmlns:text=\"urn:oasis:names:tc:opendocument:xmlns:text:1.0\" "
      "xmlns:number=\"urn:oasis:names:tc:opendocument:xmlns:datastyle:1.0\" "
      "xmlns:fo=\"urn:oasis:names:tc:opendocument:xmlns:xsl-fo-compatible:1.0\" office:version=\"1.2\"";
  const std::string declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  const std::string content = fmt::format(
      "{}<office:document-content {}><office:automatic-styles>\n{}</office:automatic-styles><office:body>"
      "<office:spreadsheet>\n{}</office:spreadsheet></office:body></office:document-content>\n",
      declaration, spaces, cellStyles(), sheets);
  const std::string styles = fmt::format("{}<office:document-styles {}/>\n", declaration, spaces);
  const std::string manifest = fmt::format(
      "{}<manifest:manifest xmlns:manifest=\"urn:oasis:names:tc:opendocument:xmlns:manifest:1.0\" "
      "manifest:version=\"1.2\">\n<manifest:file-entry manifest:full-path=\"/\" manifest:media-type=\"{}\"/>\n"
      "<manifest:file-entry manifest:full-path=\"content.xml\" manifest:media-type=\"text/xml\"/>\n"
      "<manifest:file-entry manifest:full-path=\"styles.xml\" manifest:media-type=\"text/xml\"/>\n"
      "</manifest:manifest>\n",
      declaration, mimeType);
  // The type comes first and bare, so that its place in the file is always the same (part 3, 3.3).
  return core::zipArchive(
      {{"mimetype", mimeType}, {"content.xml", content}, {"styles.xml", styles}, {"META-INF/manifest.xml", manifest}});
}

}  // namespace goniolux::project
