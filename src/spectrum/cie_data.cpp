#include "spectrum/cie_data.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "core/embedded.h"

namespace goniolux::spectrum {

std::span<const core::EmbeddedTable> cieTables();  // generated from data/cie/*.csv by cmake/embed.cmake

namespace {

constexpr double firstWavelength = 360, lastWavelength = 830;

const core::EmbeddedTable& table(std::string_view name) {
  const auto tables = cieTables();
  const auto found = std::find_if(tables.begin(), tables.end(), [&](const auto& each) { return each.name == name; });
  assert(found != tables.end());
  return *found;
}

// Column 0 is the wavelength. Beyond a table a source or an observer is taken as zero.
SpectralDistribution column(const core::EmbeddedTable& source, std::size_t index) {
  std::vector<SpectralDistribution::Sample> samples;
  const std::size_t width = source.columns.size();
  for (std::size_t i = 0; i + width <= source.values.size(); i += width) {
    samples.push_back({source.values[i], source.values[i + index]});
  }
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::zero);
}

template <typename Function>
SpectralDistribution eachNanometre(Function function) {
  std::vector<SpectralDistribution::Sample> samples;
  for (double w = firstWavelength; w <= lastWavelength; w += 1) samples.push_back({w, function(w)});
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::zero);
}

// Planck's law relative to its value at 560 nm, c2T = c2 / temperature in nm.
double planck(double wavelength, double c2T) {
  constexpr double reference = 560;
  const double x = c2T / wavelength, x0 = c2T / reference;  // expm1(x0)/expm1(x), without overflow at low temperatures
  return std::pow(reference / wavelength, 5) * std::exp(x0 - x) * std::expm1(-x0) / std::expm1(-x);
}

// Standard illuminant A keeps the constants of its definition: 100 at 560 nm, c2 = 1.435e7 nm K, T = 2848 K — ISO/CIE
// 11664-2.
SpectralDistribution illuminantA() {
  return eachNanometre([](double w) { return 100 * planck(w, 1.435e7 / 2848); });
}

bool sameIgnoringCase(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

const Observer& cie1931() {
  static const Observer observer = [] {
    const auto& source = table("cie1931_2deg");
    return Observer{column(source, 1), column(source, 2), column(source, 3)};
  }();
  return observer;
}

const SpectralDistribution& melanopicAction() {
  static const SpectralDistribution action = column(table("melanopic"), 1);
  return action;
}

std::optional<SpectralDistribution> illuminant(const std::string& name) {
  constexpr std::string_view prefix = "CIE ";
  if (name.size() <= prefix.size() || !sameIgnoringCase(std::string_view(name).substr(0, prefix.size()), prefix)) {
    return std::nullopt;
  }
  const std::string_view short_name = std::string_view(name).substr(prefix.size());
  if (sameIgnoringCase(short_name, "A")) return illuminantA();
  if (sameIgnoringCase(short_name, "E")) return SpectralDistribution::flat(1);
  for (const char* file : {"illuminant_d65", "illuminants"}) {
    const auto& source = table(file);
    for (std::size_t i = 1; i < source.columns.size(); ++i) {
      if (sameIgnoringCase(short_name, source.columns[i])) return column(source, i);
    }
  }
  return std::nullopt;
}

std::vector<std::string> illuminantNames() {
  std::vector<std::string> names{"CIE A", "CIE E"};
  for (const char* file : {"illuminant_d65", "illuminants"}) {
    for (const std::string_view name : table(file).columns.subspan(1)) names.push_back("CIE " + std::string(name));
  }
  return names;
}

SpectralDistribution blackbody(double kelvin) {
  assert(kelvin > 0);
  constexpr double c2 = 1.438776877e7;  // second radiation constant, nm K (SI 2019, exact to these digits)
  return eachNanometre([&](double w) { return planck(w, c2 / kelvin); });
}

}  // namespace goniolux::spectrum
