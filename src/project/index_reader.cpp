#include "project/index_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <vector>

#include "project/section_reader.h"
#include "project/spectrum_reader.h"

namespace goniolux::project {
namespace {

using spectrum::SpectralDistribution;

std::optional<std::vector<double>> readNumbers(const core::Value& value, const char* name, std::size_t most,
                                               Reading& reading) {
  std::vector<double> numbers;
  const bool fits = value.isArray() && !value.array().empty() && value.array().size() <= most;
  if (fits)
    for (const core::Value& number : value.array())
      if (number.isNumber()) numbers.push_back(number.number());
  if (!fits || numbers.size() != value.array().size()) {
    reading.error(value, "wrong-type", fmt::format("\"{}\" must be a list of 1 to {} numbers", name, most));
    return std::nullopt;
  }
  return numbers;
}

/// At 5 nm over the visible range; `index` takes the wavelength in micrometres, squared.
std::optional<SpectralDistribution> tabulated(const core::Value& at, const std::function<double(double)>& index,
                                              Reading& reading) {
  std::vector<SpectralDistribution::Sample> samples;
  for (int nm = 360; nm <= 830; nm += 5) {
    const double micrometres = nm / 1000.0, n = index(micrometres * micrometres);
    if (!(n >= 0.01) || !(n < 100)) {
      reading.error(at, "out-of-range",
                    fmt::format("this formula gives the refractive index {:g} at {} nm; its wavelengths are in "
                                "micrometres (a crown glass: \"cauchy\": [1.5046, 0.0042])",
                                n, nm));
      return std::nullopt;
    }
    samples.push_back({static_cast<double>(nm), n});
  }
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::hold);
}

std::optional<SpectralDistribution> cauchy(const core::Value& value, Reading& reading) {
  const auto c = readNumbers(value, "cauchy", 4, reading);
  if (!c) return std::nullopt;
  return tabulated(
      value,
      [&](double squared) {
        double n = 0;
        for (std::size_t i = c->size(); i-- > 0;) n = n / squared + (*c)[i];
        return n;
      },
      reading);
}

std::optional<SpectralDistribution> sellmeier(const core::Value& value, Reading& reading) {
  SectionReader section(value, sellmeierSection(), reading);
  if (section.failed()) return std::nullopt;
  const auto b = readNumbers(*section.find("b"), "b", 6, reading), c = readNumbers(*section.find("c"), "c", 6, reading);
  if (!b || !c) return std::nullopt;
  if (b->size() != c->size()) {
    reading.error(value, "spectrum-form", "\"b\" and \"c\" must be two lists of the same length");
    return std::nullopt;
  }
  return tabulated(
      value,
      [&](double squared) {
        double n = 1;
        for (std::size_t i = 0; i < b->size(); ++i) n += (*b)[i] * squared / (squared - (*c)[i]);
        return n > 0 ? std::sqrt(n) : -1;
      },
      reading);
}

}  // namespace

std::optional<SpectralDistribution> readRefractiveIndex(const core::Value& value, const Key& key, Reading& reading) {
  if (value.isObject() && (value.find("cauchy") || value.find("sellmeier"))) {
    SectionReader section(value, dispersionSection(), reading);
    if (section.failed()) return std::nullopt;
    if (section.has("cauchy") && section.has("sellmeier")) {
      reading.error(value, "spectrum-form", "a refractive index is either \"cauchy\" or \"sellmeier\"; leave one out");
      return std::nullopt;
    }
    return section.has("cauchy") ? cauchy(*section.find("cauchy"), reading)
                                 : sellmeier(*section.find("sellmeier"), reading);
  }
  auto index = readSpectrum(value, key, spectrum::Role::coefficient, reading);
  if (index && !(index->range().first > 0)) {
    reading.error(value, "out-of-range", fmt::format("\"{}\" must be above 0; air is 1, glass about 1.5", key.name));
    return std::nullopt;
  }
  return index;
}

}  // namespace goniolux::project
