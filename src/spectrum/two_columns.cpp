#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>

#include "spectrum/spectrum_table.h"

namespace goniolux::spectrum {
namespace {

constexpr std::size_t mostComplaints = 20;  // a binary file should not fill the screen

struct Field {
  std::string_view text;
  int column;
};

bool isBlank(char c) {
  return c == ' ' || c == '\t';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && (isBlank(text.back()) || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

// One separator a line, the strongest that occurs: semicolon, tab, comma, blanks.
std::vector<Field> split(std::string_view line) {
  const char separator = line.find(';') != line.npos    ? ';'
                         : line.find('\t') != line.npos ? '\t'
                         : line.find(',') != line.npos  ? ','
                                                        : ' ';
  std::vector<Field> fields;
  std::size_t begin = 0;
  while (begin <= line.size()) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    const std::string_view field = trimmed(line.substr(begin, end - begin));
    const bool unquoted = field.size() < 2 || field.front() != '"' || field.back() != '"';
    const std::string_view text = unquoted ? field : field.substr(1, field.size() - 2);
    if (!text.empty()) fields.push_back({text, static_cast<int>(text.data() - line.data()) + 1});
    begin = end + 1;
  }
  return fields;
}

std::optional<double> number(std::string_view text, bool decimalComma) {
  std::string copy(text);
  if (decimalComma) std::replace(copy.begin(), copy.end(), ',', '.');
  const char* begin = copy.data();
  const char* end = begin + copy.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<double> wavelength(std::string_view text, bool decimalComma) {
  if (text.size() > 2 && text.substr(text.size() - 2) == "nm") text = trimmed(text.substr(0, text.size() - 2));
  return number(text, decimalComma);
}

// A token as it can be shown: short, and without bytes that are not plain text.
std::string shown(std::string_view text) {
  std::string result(text.substr(0, 24));
  for (char& c : result) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text.size() > 24 ? result + "..." : result;
}

}  // namespace

SpectrumTable parseTwoColumns(const std::string& text, const std::string& name, core::Diagnostics& diagnostics) {
  SpectrumTable table;
  if (text.find('\0') != std::string::npos) {
    diagnostics.error({name, 0, 0}, "not-text",
                      "this is not a text file of two columns; save it as plain text (not UTF-16, not a spreadsheet)");
    return table;
  }
  std::string_view rest = text;
  if (rest.substr(0, 3) == "\xEF\xBB\xBF") rest.remove_prefix(3);
  int lineNumber = 0;
  while (!rest.empty() && diagnostics.all().size() < mostComplaints) {
    ++lineNumber;
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    line = line.substr(0, line.find('#'));
    if (trimmed(line).empty()) continue;

    const bool decimalComma = line.find_first_of(";\t") != line.npos;
    const auto fields = split(line);
    if (fields.empty()) continue;
    const core::SourcePosition first{name, lineNumber, fields[0].column};
    const auto w = wavelength(fields[0].text, decimalComma);
    if (!w) {
      if (table.rows.empty()) continue;  // still the head
      diagnostics.error(first, "not-a-number",
                        fmt::format("'{}' is not a wavelength; write a number of nanometres", shown(fields[0].text)));
      continue;
    }
    if (fields.size() != 2) {
      diagnostics.error(
          fields.size() < 2 ? first : core::SourcePosition{name, lineNumber, fields[2].column}, "columns",
          fmt::format("{} column(s) found, two expected (wavelength, value); keep one value per line", fields.size()));
      continue;
    }
    const core::SourcePosition second{name, lineNumber, fields[1].column};
    const auto value = number(fields[1].text, decimalComma);
    if (!value) {
      diagnostics.error(second, "not-a-number", fmt::format("'{}' is not a number", shown(fields[1].text)));
      continue;
    }
    table.rows.push_back({*w, *value, first, second});
  }
  return table;
}

}  // namespace goniolux::spectrum
