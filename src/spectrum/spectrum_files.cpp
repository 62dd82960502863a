#include "spectrum/spectrum_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/document.h"
#include "spectrum/cie_data.h"
#include "spectrum/spectrum_table.h"

namespace goniolux::spectrum {
namespace {

bool isShare(Role role) {
  return role == Role::reflectance || role == Role::transmittance;
}

const char* nameOf(Role role) {
  switch (role) {
    case Role::source:
      return "source";
    case Role::reflectance:
      return "reflectance";
    case Role::transmittance:
      return "transmittance";
    case Role::coefficient:
      return "coefficient";
  }
  return "";
}

// Files in micrometres or angstroms are numbers too: the range of a table gives them away.
void checkUnit(const SpectrumTable& table, core::Diagnostics& diagnostics) {
  const auto& first = table.rows.front();
  const auto& last = table.rows.back();
  if (last.wavelength > 0 && last.wavelength < 20) {
    diagnostics.error(
        first.wavelengthAt, "wavelength-unit",
        fmt::format("wavelengths {} to {} look like micrometres; give nanometres", first.wavelength, last.wavelength));
  } else if (first.wavelength > 2500) {
    diagnostics.error(
        first.wavelengthAt, "wavelength-unit",
        fmt::format("wavelengths from {} on lie in the infrared, or are angstroms; give nanometres", first.wavelength));
  }
}

void checkOrder(const SpectrumTable& table, core::Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    if (!std::isfinite(row.wavelength) || row.wavelength <= 0) {
      diagnostics.error(row.wavelengthAt, "wavelength", fmt::format("{} is no wavelength", row.wavelength));
    } else if (i > 0 && row.wavelength == table.rows[i - 1].wavelength) {
      diagnostics.error(row.wavelengthAt, "repeated-wavelength",
                        fmt::format("wavelength {} nm stands twice; keep one of them", row.wavelength));
    } else if (i > 0 && row.wavelength < table.rows[i - 1].wavelength) {
      diagnostics.error(row.wavelengthAt, "unsorted-wavelengths",
                        fmt::format("wavelength {} nm comes after {} nm; sort the lines by ascending wavelength",
                                    row.wavelength, table.rows[i - 1].wavelength));
      return;  // in a descending file every line would say so
    }
  }
}

void checkValues(SpectrumTable& table, Role role, core::Diagnostics& diagnostics, core::Diagnostics* warnings) {
  double largest = 0;
  for (const auto& row : table.rows) {
    if (std::isfinite(row.value)) largest = std::max(largest, row.value);
  }
  // Shares above 1.5 are no slip of a digit: such a table counts in percent.
  const bool percent = isShare(role) && largest > 1.5 && largest <= 110;
  // Meters subtract their dark signal: a little noise below zero is zero. A hundredth of the peak is no noise.
  const double noise = role == Role::source ? -0.01 * largest : 0;
  bool cut = false;
  for (auto& row : table.rows) {
    if (!std::isfinite(row.value)) {
      diagnostics.error(row.valueAt, "not-a-number", fmt::format("{} is no value of a {}", row.value, nameOf(role)));
    } else if (row.value < noise) {
      diagnostics.error(
          row.valueAt, "negative-value",
          fmt::format("{} {} is negative; values of a {} are 0 or more", nameOf(role), row.value, nameOf(role)));
    } else if (row.value < 0) {
      if (!cut && warnings != nullptr) {
        warnings->warning(row.valueAt, "negative-value",
                          fmt::format("{} is slightly negative and taken as 0, like any such value below", row.value));
      }
      cut = true;
      row.value = 0;
    } else if (isShare(role) && row.value > 1) {
      diagnostics.error(
          row.valueAt, percent ? "percent" : "above-one",
          percent ? fmt::format("{} of {} looks like percent (the largest value is {}); divide all values by 100",
                                nameOf(role), row.value, largest)
                  : fmt::format("{} {} is above 1: more light would leave than arrives", nameOf(role), row.value));
      if (percent) return;  // once is enough
    }
  }
}

// TM-27 names the quantity; "relative" and "other" fit everything.
void checkQuantity(const SpectrumTable& table, Role role, core::Diagnostics& diagnostics) {
  const bool sourceWanted = role == Role::source;
  for (const char* share : {"reflectance", "transmittance", "absorptance"}) {
    if (table.quantity == share && (sourceWanted || (isShare(role) && table.quantity != nameOf(role)))) {
      diagnostics.error(table.quantityAt, "quantity",
                        fmt::format("this file holds a {}; a {} is wanted here", table.quantity, nameOf(role)));
    }
  }
  for (const char* power : {"flux", "intensity", "irradiance", "radiance", "exitance", "W/nm"}) {
    if (table.quantity == power && !sourceWanted) {
      diagnostics.error(table.quantityAt, "quantity",
                        fmt::format("this file holds the spectrum of a source ({}); a {} is wanted here",
                                    table.quantity, nameOf(role)));
    }
  }
}

// A step far wider than the others' is a hole in the data, unless the whole table is coarse.
void warnOfHoles(const SpectrumTable& table, core::Diagnostics& warnings) {
  constexpr double wide = 25, ratio = 4;  // nm; times the usual step
  std::vector<double> steps;
  for (std::size_t i = 1; i < table.rows.size(); ++i)
    steps.push_back(table.rows[i].wavelength - table.rows[i - 1].wavelength);
  std::vector<double> sorted = steps;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] <= wide || steps[i] <= ratio * usual) continue;
    warnings.warning(
        table.rows[i + 1].wavelengthAt, "gap",
        fmt::format("nothing stands between {} and {} nm, where the usual step is {} nm: a straight line is drawn; "
                    "fill in what is missing",
                    table.rows[i].wavelength, table.rows[i + 1].wavelength, usual));
  }
}

void warnOfGaps(const SpectrumTable& table, const std::string& name, Role role, core::Diagnostics& warnings) {
  warnOfHoles(table, warnings);
  const double from = table.rows.front().wavelength, to = table.rows.back().wavelength;
  if (from <= 400 && to >= 700) return;
  warnings.warning({name, 0, 0}, "range",
                   fmt::format("the file covers {} to {} nm only; beyond that the {} is taken as {}", from, to,
                               nameOf(role), role == Role::source ? "0" : "constant"));
}

bool endsInSpdx(const std::string& name) {
  std::string ending = name.substr(name.size() - std::min<std::size_t>(name.size(), 5));
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending == ".spdx";
}

}  // namespace

SpectralDistribution readSpectrum(const std::string& text, const std::string& name, Role role,
                                  core::Diagnostics* warnings) {
  core::Diagnostics diagnostics;
  SpectrumTable table =
      endsInSpdx(name) ? parseTm27(text, name, diagnostics) : parseTwoColumns(text, name, diagnostics);
  if (!diagnostics.hasErrors() && table.rows.size() < 2) {
    diagnostics.error(
        {name, 0, 0}, "no-spectrum",
        fmt::format("{} line(s) with a wavelength and a value found; a spectrum needs two or more", table.rows.size()));
  }
  if (table.rows.size() >= 2) {
    checkUnit(table, diagnostics);
    if (!diagnostics.hasErrors()) checkOrder(table, diagnostics);
    checkQuantity(table, role, diagnostics);
    checkValues(table, role, diagnostics, warnings);
  }
  if (diagnostics.hasErrors()) throw core::InputError(std::move(diagnostics));

  std::vector<SpectralDistribution::Sample> samples;
  samples.reserve(table.rows.size());
  for (const auto& row : table.rows) samples.push_back({row.wavelength, row.value});
  using Outside = SpectralDistribution::Outside;
  auto result = SpectralDistribution::sampled(std::move(samples), role == Role::source ? Outside::zero : Outside::hold);
  if (role == Role::source && !(result.integral(cie1931().ybar) > 0)) {
    throw core::InputError({name, 0, 0}, "dark-source", "this spectrum has no visible light between 360 and 830 nm");
  }
  if (warnings != nullptr) warnOfGaps(table, name, role, *warnings);
  return result;
}

SpectralDistribution readSpectrumFile(const std::string& path, Role role, core::Diagnostics* warnings) {
  return readSpectrum(core::readFile(path), path, role, warnings);
}

}  // namespace goniolux::spectrum
