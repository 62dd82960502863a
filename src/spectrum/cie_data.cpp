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

Observer observerOf(std::string_view name) {
  const auto& source = table(name);
  return {column(source, 1), column(source, 2), column(source, 3)};
}

// One per column; the ends go on.
std::vector<SpectralDistribution> reflectancesOf(std::string_view name) {
  const auto& source = table(name);
  std::vector<SpectralDistribution> list;
  for (std::size_t i = 1; i < source.columns.size(); ++i) {
    const auto factor = column(source, i);
    list.push_back(SpectralDistribution::sampled({factor.samples().begin(), factor.samples().end()},
                                                 SpectralDistribution::Outside::hold));
  }
  return list;
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
  static const Observer observer = observerOf("cie1931_2deg");
  return observer;
}

const Observer& cie1964() {
  static const Observer observer = observerOf("cie1964_10deg");
  return observer;
}

const SpectralDistribution& alphaOpicAction(AlphaOpic response) {
  static const std::vector<SpectralDistribution> actions = [] {
    const auto& source = table("alpha_opic");
    std::vector<SpectralDistribution> list;
    for (std::size_t i = 1; i < source.columns.size(); ++i) list.push_back(column(source, i));
    return list;
  }();
  return actions[static_cast<std::size_t>(response)];
}

double alphaOpicEfficacyOfD65(AlphaOpic response) {
  constexpr double ofD65[] = {0.8173, 1.4558, 1.6289, 1.4497, 1.3262};  // CIE S 026:2018, Table 3
  return ofD65[static_cast<std::size_t>(response)];
}

const SpectralDistribution& scotopicEfficiency() {
  static const SpectralDistribution efficiency = column(table("scotopic"), 1);
  return efficiency;
}

const std::vector<SpectralDistribution>& testColours() {
  static const std::vector<SpectralDistribution> samples = reflectancesOf("test_colours");
  return samples;
}

const std::vector<SpectralDistribution>& colourEvaluationSamples() {
  static const std::vector<SpectralDistribution> samples = reflectancesOf("colour_evaluation_samples");
  return samples;
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

SpectralDistribution daylight(double kelvin) {
  assert(kelvin >= 4000 && kelvin <= 25000);
  const double T = kelvin;
  const double x = T <= 7000 ? -4.6070e9 / (T * T * T) + 2.9678e6 / (T * T) + 0.09911e3 / T + 0.244063
                             : -2.0064e9 / (T * T * T) + 1.9018e6 / (T * T) + 0.24748e3 / T + 0.237040;
  const double y = -3.000 * x * x + 2.870 * x - 0.275;
  const double M = 0.0241 + 0.2562 * x - 0.7341 * y;
  const double M1 = (-1.3515 - 1.7703 * x + 5.9114 * y) / M, M2 = (0.0300 - 31.4424 * x + 30.0717 * y) / M;
  const auto& components = table("daylight").values;
  std::vector<SpectralDistribution::Sample> samples;
  for (std::size_t i = 0; i + 4 <= components.size(); i += 4) {
    samples.push_back({components[i], components[i + 1] + M1 * components[i + 2] + M2 * components[i + 3]});
  }
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::zero);
}

SpectralDistribution blackbody(double kelvin) {
  assert(kelvin > 0);
  constexpr double c2 = 1.438776877e7;  // second radiation constant, nm K (SI 2019, exact to these digits)
  return eachNanometre([&](double w) { return planck(w, c2 / kelvin); });
}

}  // namespace goniolux::spectrum
