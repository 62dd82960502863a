// LM-63-2019. Sign patterns of openings: lm63_opening.cpp.
#include <fmt/format.h>

#include <array>
#include <utility>

#include "photometry/lm63.h"
#include "photometry/writers.h"

namespace goniolux::photometry {
namespace {

constexpr std::size_t longestLine = 120;

// Keywords by their LM-63 names: those of other formats begin with an underscore, as the standard asks of additions.
std::string keywordLines(const PhotometricFile& file) {
  static constexpr std::array<std::pair<const char*, const char*>, 5> renamed{{{"DATE", "ISSUEDATE"},
                                                                               {"COLOUR", "_COLOUR"},
                                                                               {"COLOURRENDERING", "_COLOURRENDERING"},
                                                                               {"FILENAME", "_FILENAME"},
                                                                               {"TEXT", "OTHER"}}};
  std::map<std::string, std::string> keywords;
  for (const auto& [key, value] : file.keywords) {
    std::string name = key;
    for (const auto& [from, to] : renamed)
      if (key == from) name = to;
    keywords.try_emplace(name, value);
  }
  for (const char* required : {"TEST", "TESTLAB", "ISSUEDATE", "MANUFAC"}) keywords.try_emplace(required, "not stated");
  if (file.declaredLuminaireLumens)
    keywords.try_emplace("_TOTALLUMINAIRELUMENS", fmt::format("{}", *file.declaredLuminaireLumens));
  std::string lines;
  const auto add = [&](const std::string& key, const std::string& value) {
    std::string name = key;
    for (std::size_t begin = 0; begin <= value.size();) {
      const std::size_t end = std::min(value.find('\n', begin), value.size());
      lines += fmt::format("[{}] {}\r\n", name, value.substr(begin, end - begin));
      name = "MORE";
      begin = end + 1;
    }
  };
  for (const char* first : {"TEST", "TESTLAB", "ISSUEDATE", "MANUFAC"}) add(first, keywords.at(first));
  for (const auto& [key, value] : keywords)
    if (key != "TEST" && key != "TESTLAB" && key != "ISSUEDATE" && key != "MANUFAC") add(key, value);
  return lines;
}

std::string numberLines(const std::vector<double>& values) {
  std::string text, line;
  for (const double value : values) {
    const std::string number = fmt::format("{}", value);
    if (!line.empty() && line.size() + 1 + number.size() > longestLine) {
      text += line + "\r\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + number;
  }
  return text + line + "\r\n";
}

// Width, length and height with the signs of the 2002 and 2019 editions; width lies across C0, length along it.
std::array<double, 3> dimensions(const StatedOpening& o, core::Diagnostics& warnings, const std::string& file) {
  using Shape = StatedOpening::Shape;
  using Axis = StatedOpening::Axis;
  const double along = o.lengthAlongC90 ? o.width : o.length, across = o.lengthAlongC90 ? o.length : o.width;
  const bool axisAlong = (o.axis == Axis::lengthwise) != o.lengthAlongC90;  // for an axis that is not the aim
  switch (o.shape) {
    case Shape::point:
      return {0, 0, 0};
    case Shape::rectangle:
    case Shape::box:
    case Shape::line:
      return {across, along, o.height};
    case Shape::disc:
      if (o.axis == Axis::aim) return {-across, -along, 0};
      return axisAlong ? std::array<double, 3>{-across, 0, -o.height} : std::array<double, 3>{0, -along, -o.height};
    case Shape::cylinder:
      if (o.axis == Axis::aim) return {-across, -along, o.height};
      return axisAlong ? std::array<double, 3>{-across, along, -o.height}
                       : std::array<double, 3>{across, -along, -o.height};
    case Shape::sphere:
      return {-across, -along, -o.height};
    case Shape::other:
      break;
  }
  warnings.warning({file, 0, 0}, "opening-lost", "the opening is none that LM-63 knows; a point is written: " + o.note);
  return {0, 0, 0};
}

}  // namespace

std::string writeLm63(const PhotometricFile& file, core::Diagnostics& warnings) {
  const TabulatedDistribution& d = *file.distribution;
  std::vector<double> planes = d.horizontalAngles();
  const std::size_t stated = planes.size(), n = d.verticalAngles().size();
  // The standard's planes without symmetry run to 360.
  if (d.type() == PhotometryType::c && d.symmetry() == HorizontalSymmetry::none && planes.back() < 360 - 1e-6)
    planes.push_back(360);
  const std::array<double, 3> size = dimensions(file.opening, warnings, file.file);
  const int type = d.type() == PhotometryType::c ? 1 : d.type() == PhotometryType::b ? 2 : 3;
  std::string text = "IES:LM-63-2019\r\n" + keywordLines(file) + "TILT=NONE\r\n";
  text += fmt::format("1 {} 1 {} {} {} 2 {} {} {}\r\n", file.declaredLumens.value_or(-1), n, planes.size(), type,
                      size[0], size[1], size[2]);
  text += fmt::format("1 1.00001 {}\r\n", file.inputWatts);  // file generation type: undefined
  text += numberLines(d.verticalAngles()) + numberLines(planes);
  for (std::size_t h = 0; h < planes.size(); ++h) {
    std::vector<double> row(n);
    for (std::size_t v = 0; v < n; ++v) row[v] = d.candela(h < stated ? h : 0, v);
    text += numberLines(row);
  }
  if (file.tilt) {
    warnings.warning({file.file, 0, 0}, "tilt-lost",
                     "the table of lamp output against tilt is not written; the candelas are those of 0 degrees");
  }
  return text;
}

}  // namespace goniolux::photometry
