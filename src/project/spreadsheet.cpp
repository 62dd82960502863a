#include "project/spreadsheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/markup.h"
#include "core/zip.h"

namespace goniolux::project {
namespace {

using core::Estimate;

constexpr const char* mimeType = "application/vnd.oasis.opendocument.spreadsheet";

/// A sheet as it grows, row by row.
class Sheet {
 public:
  explicit Sheet(const std::string& name) {
    xml_ = fmt::format("<table:table table:name=\"{}\"><table:table-column table:number-columns-repeated=\"24\"/>",
                       core::escapedMarkup(name));
  }
  Sheet& text(const std::string& value, bool isHeader = false) {
    row_ += fmt::format("<table:table-cell{} office:value-type=\"string\"><text:p>{}</text:p></table:table-cell>",
                        isHeader ? " table:style-name=\"header\"" : "", core::escapedMarkup(value));
    return *this;
  }
  /// A number that does not exist (a point inside a solid) is an empty cell.
  Sheet& number(double value) {
    row_ += std::isfinite(value)
                ? fmt::format(
                      "<table:table-cell office:value-type=\"float\" office:value=\"{}\"><text:p>{:.6g}"
                      "</text:p></table:table-cell>",
                      value, value)
                : "<table:table-cell/>";
    return *this;
  }
  Sheet& estimate(const Estimate& e) { return number(e.value).number(e.halfWidth()); }
  Sheet& headers(std::initializer_list<std::string> names) {
    for (const std::string& name : names) text(name, true);
    return end();
  }
  Sheet& end() {
    xml_ += "<table:table-row>" + (row_.empty() ? std::string("<table:table-cell/>") : row_) + "</table:table-row>\n";
    row_.clear();
    return *this;
  }
  [[nodiscard]] std::string xml() const { return xml_ + "</table:table>\n"; }

 private:
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

std::string summary(const Results& results, const std::string& name) {
  Sheet sheet(name);
  sheet.text(results.project, true).end();
  sheet.text(fmt::format("half-widths (±) at {:g} % confidence", 100 * results.confidence)).end().end();
  sheet.headers({"Grid", "Quantity", "Unit", "Mean", "±", "Minimum", "±", "Maximum", "±", "U0", "±"});
  for (const GridResult& grid : results.grids)
    sheet.text(grid.name)
        .text(grid.quantity)
        .text(grid.unit)
        .estimate(grid.mean)
        .estimate(grid.min)
        .estimate(grid.max)
        .estimate(grid.u0)
        .end();
  if (!results.observers.empty()) sheet.end().headers({"Observer", "Quantity", "Value", "±"});
  for (const ObserverResult& observer : results.observers)
    sheet.text(observer.name).text(observer.quantity).estimate(observer.value).end();
  if (!results.requirements.empty())
    sheet.end().headers({"Requirement", "Quantity", "At least", "At most", "Calculated", "±", "Verdict", "Clause"});
  for (const RequirementResult& r : results.requirements) {
    sheet.text(r.of.empty() ? r.text : r.of).text(r.quantity);
    sheet.number(r.minimum.value_or(NAN)).number(r.maximum.value_or(NAN));
    if (r.found)
      sheet.estimate(*r.found);
    else
      sheet.number(NAN).number(NAN);
    sheet.text(wordFor(r.verdict)).text(r.clause).end();
  }
  return sheet.xml();
}

std::string pointList(const GridResult& grid, const std::string& name) {
  Sheet sheet(name);
  sheet.headers({"x / m", "y / m", "z / m", inUnit(grid.quantity, grid.unit), inUnit("±", grid.unit)});
  for (std::size_t i = 0; i < grid.points.size(); ++i)
    sheet.number(grid.points[i].x)
        .number(grid.points[i].y)
        .number(grid.points[i].z)
        .number(grid.values[i])
        .number(grid.halfWidths[i])
        .end();
  return sheet.xml();
}

/// Distances along the edges from the grid's first point, as a reader of a plan counts them.
std::string inThePlane(const GridResult& grid, const std::string& name) {
  Sheet sheet(name);
  const std::size_t nu = static_cast<std::size_t>((*grid.counts)[0]), nv = static_cast<std::size_t>((*grid.counts)[1]);
  sheet.text(inUnit(grid.quantity, grid.unit) + "; right: along u / m, up: along v / m", true).end();
  for (std::size_t j = nv; j-- > 0;) {
    sheet.number(glm::length(grid.points[j * nu] - grid.points[0]));
    for (std::size_t i = 0; i < nu; ++i) sheet.number(grid.values[j * nu + i]);
    sheet.end();
  }
  sheet.text("v, u");
  for (std::size_t i = 0; i < nu; ++i) sheet.number(glm::length(grid.points[i] - grid.points[0]));
  return sheet.end().xml();
}

std::string howMade(const Results& results, const std::string& name) {
  Sheet sheet(name);
  sheet.text("Program").text("Goniolux " + results.programVersion).end();
  sheet.text("Project hash").text(results.projectHash).end();
  sheet.text("Seed").text(std::to_string(results.seed)).end();
  if (!results.lightingScene.empty()) sheet.text("Lighting scene").text(results.lightingScene).end();
  if (!results.reachedText.empty()) sheet.text("Accuracy").text(results.reachedText).end();
  for (const std::string& sentence : results.leftOut) sheet.text("Left out").text(sentence).end();
  for (const InputFile& input : results.inputs) sheet.text("Input").text(input.path).text(input.sha256).end();
  return sheet.xml();
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
      "xmlns:fo=\"urn:oasis:names:tc:opendocument:xmlns:xsl-fo-compatible:1.0\" office:version=\"1.2\"";
  const std::string declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  const std::string content = fmt::format(
      "{}<office:document-content {}><office:automatic-styles><style:style style:name=\"header\" "
      "style:family=\"table-cell\"><style:text-properties fo:font-weight=\"bold\"/></style:style>"
      "</office:automatic-styles><office:body><office:spreadsheet>\n{}</office:spreadsheet></office:body>"
      "</office:document-content>\n",
      declaration, spaces, sheets);
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
