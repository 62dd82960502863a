#include "spectrum/nk_file.h"

#include <fmt/format.h>

#include <charconv>
#include <sstream>
#include <vector>

#include "core/document.h"
#include "spectrum/spectrum_files.h"

namespace goniolux::spectrum {
namespace {

bool isNumber(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

std::vector<std::string> columnsOf(std::string line) {
  for (char& c : line)
    if (c == ',' || c == ';' || c == '\t' || c == '\r') c = ' ';
  std::istringstream stream(line.substr(0, line.find('#')));
  std::vector<std::string> columns;
  for (std::string column; stream >> column;) columns.push_back(column);
  return columns;
}

}  // namespace

ComplexIndex readComplexIndex(const std::string& text, const std::string& name, core::Diagnostics* warnings) {
  // As two files of two columns, line by line, so that everything is checked as there.
  std::string n, k;
  core::Diagnostics faults;
  std::istringstream lines(text);
  bool begun = false;
  int lineNumber = 0;
  for (std::string line; std::getline(lines, line); n += '\n', k += '\n') {
    ++lineNumber;
    const auto columns = columnsOf(line);
    if (columns.empty() || (!begun && !isNumber(columns[0]))) continue;
    begun = true;
    if (columns.size() != 3) {
      faults.error({name, lineNumber, 1}, "columns",
                   fmt::format("{} column(s) found, three expected (wavelength in nm, n, k)", columns.size()));
      if (faults.all().size() >= 20) break;
      continue;
    }
    n += columns[0] + ' ' + columns[1];
    k += columns[0] + ' ' + columns[2];
  }
  if (faults.hasErrors()) throw core::InputError(faults);
  ComplexIndex index{readSpectrum(n, name, Role::coefficient, warnings), readSpectrum(k, name, Role::coefficient)};
  if (index.n.samples().size() > 0 && index.n.samples().back().wavelength < 50)
    throw core::InputError({name, lineNumber, 1}, "wavelengths",
                           "wavelengths of an .nk file are in nm; these look like micrometres: multiply them by 1000");
  return index;
}

ComplexIndex readComplexIndexFile(const std::string& path, core::Diagnostics* warnings) {
  return readComplexIndex(core::readFile(path), path, warnings);
}

}  // namespace goniolux::spectrum
