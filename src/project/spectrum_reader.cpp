#include "project/spectrum_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "core/closest_name.h"
#include "project/section_reader.h"
#include "spectrum/cie_data.h"
#include "spectrum/smooth_reflectance.h"

namespace goniolux::project {
namespace {

using spectrum::Role;
using spectrum::SpectralDistribution;

bool isFraction(Role role) {
  return role == Role::reflectance || role == Role::transmittance;
}

SpectralDistribution::Outside outsideOf(Role role) {
  return role == Role::source ? SpectralDistribution::Outside::zero : SpectralDistribution::Outside::hold;
}

bool looksLikeFile(const std::string& name) {
  std::string extension = std::filesystem::path(name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static const std::array<const char*, 6> known{".spd", ".csv", ".spdx", ".nk", ".txt", ".xml"};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

class SpectrumReader {
 public:
  SpectrumReader(const Key& key, Role role, Reading& reading) : key_(key), role_(role), reading_(reading) {}

  std::optional<SpectralDistribution> read(const core::Value& value) {
    if (value.isNumber()) return flat(value);
    if (value.isString()) return named(value);
    if (value.isObject()) return object(value);
    reading_.error(
        value, "wrong-type",
        fmt::format("\"{}\" must be a spectrum: a number, a file, the name of an illuminant or an object", key_.name));
    return std::nullopt;
  }

 private:
  std::optional<SpectralDistribution> flat(const core::Value& value) {
    const auto number = readNumber(value, key_, reading_);
    return number ? std::optional(SpectralDistribution::flat(*number)) : std::nullopt;
  }

  std::optional<SpectralDistribution> named(const core::Value& value) {
    const std::string& name = value.string();
    if (looksLikeFile(name)) return file(value);
    if (auto lamp = spectrum::illuminant(name)) {
      if (role_ == Role::source) return lamp;
      reading_.error(
          value, "wrong-spectrum",
          fmt::format("\"{}\" is the light of \"{}\"; a number or a measured curve is needed", key_.name, name));
      return std::nullopt;
    }
    const auto known = role_ == Role::source ? spectrum::illuminantNames() : std::vector<std::string>{};
    reading_.error(value, "unknown-spectrum",
                   fmt::format("\"{}\" is no spectrum: neither a file (.spd, .csv, .spdx) nor a known illuminant{}",
                               name, core::suggestion(name, known)));
    return std::nullopt;
  }

  std::optional<SpectralDistribution> file(const core::Value& value) {
    if (std::filesystem::path(value.string()).extension() == ".nk") {
      reading_.notSupported(value.position(), "n and k from an .nk file");
      return std::nullopt;
    }
    const auto path = reading_.file(value, Library::materials);
    if (!path) return std::nullopt;
    try {
      return spectrum::readSpectrumFile(*path, role_, &reading_.diagnostics);
    } catch (const core::InputError& error) {
      reading_.adopt(error);
      return std::nullopt;
    }
  }

  std::optional<SpectralDistribution> object(const core::Value& value) {
    SectionReader section(value, spectrumSection(), reading_);
    if (section.failed()) return std::nullopt;
    const bool sampledForm = section.has("wavelengths") || section.has("values");
    const bool lineForm = section.has("lines") || section.has("continuum");
    const bool colourForm = section.has("xyz") || section.has("srgb");
    const int forms = int{sampledForm} + int{lineForm} + int{section.has("blackbody")} + int{colourForm};
    if (forms != 1) {
      reading_.error(
          value, "spectrum-form",
          "a spectrum has either \"wavelengths\" and \"values\", or \"blackbody\", or \"lines\" with \"continuum\", "
          "or \"xyz\", or \"srgb\"");
      return std::nullopt;
    }
    if (colourForm) return fromColour(value, section);
    if (sampledForm) return sampled(value, section);
    if (lineForm) return withLines(value, section);
    return blackbody(section);
  }

  std::optional<SpectralDistribution> blackbody(SectionReader& section) {
    const auto kelvin = section.number("blackbody");
    if (!kelvin || !sourceOnly(*section.find("blackbody"))) return std::nullopt;
    return spectrum::blackbody(*kelvin);
  }

  bool sourceOnly(const core::Value& at) {
    if (role_ == Role::source) return true;
    reading_.error(at, "wrong-spectrum", fmt::format("\"{}\" cannot be the spectrum of a light source", key_.name));
    return false;
  }

  std::optional<SpectralDistribution> sampled(const core::Value& value, SectionReader& section) {
    const core::Value* wavelengths = section.find("wavelengths");
    const core::Value* values = section.find("values");
    if (!wavelengths || !values || !wavelengths->isArray() || !values->isArray() ||
        wavelengths->array().size() != values->array().size() || wavelengths->array().empty()) {
      reading_.error(value, "spectrum-form", "\"wavelengths\" and \"values\" must be two lists of the same length");
      return std::nullopt;
    }
    std::vector<SpectralDistribution::Sample> samples;
    const Key wavelengthKey{.name = "wavelengths", .minimum = 0, .minimumIsAllowed = false};
    for (std::size_t i = 0; i < values->array().size(); ++i) {
      const auto wavelength = readNumber(wavelengths->array()[i], wavelengthKey, reading_);
      const auto number = readNumber(values->array()[i], key_, reading_);
      if (!wavelength || !number) return std::nullopt;
      if (!samples.empty() && *wavelength <= samples.back().wavelength) {
        reading_.error(
            wavelengths->array()[i], "spectrum-form",
            fmt::format("wavelengths must ascend: {} nm follows {} nm", *wavelength, samples.back().wavelength));
        return std::nullopt;
      }
      samples.push_back({*wavelength, *number});
    }
    return SpectralDistribution::sampled(std::move(samples), outsideOf(role_));
  }

  std::optional<SpectralDistribution> withLines(const core::Value& value, SectionReader& section) {
    const core::Value* lines = section.find("lines");
    if (!lines) {
      reading_.error(value, "spectrum-form", "\"continuum\" goes with \"lines\": [[nm, power], …]");
      return std::nullopt;
    }
    if (!sourceOnly(*lines)) return std::nullopt;
    SpectralDistribution result;
    if (const core::Value* continuum = section.find("continuum")) {
      // Nesting has no use and no end: a continuum is a spectrum without lines of its own.
      if (continuum->isObject() && continuum->find("lines")) {
        reading_.error(*continuum, "spectrum-form", "a continuum has no \"lines\" of its own; list all lines together");
        return std::nullopt;
      }
      auto base = read(*continuum);
      if (!base) return std::nullopt;
      result = std::move(*base);
    }
    const auto pairs = readPairs(*lines, *spectrumSection().find("lines"), reading_);
    if (!pairs) return std::nullopt;
    for (std::size_t i = 0; i < pairs->size(); ++i) {
      const core::Vec2& line = (*pairs)[i];
      if (!(line.x > 0) || line.y < 0) {
        reading_.error(lines->array()[i], "out-of-range",
                       "a line needs a wavelength above 0 nm and a power of at least 0");
        return std::nullopt;
      }
      result.addLine({line.x, line.y});
    }
    return result;
  }

  std::optional<SpectralDistribution> fromColour(const core::Value& value, SectionReader& section) {
    const char* name = section.has("srgb") ? "srgb" : "xyz";
    if (section.has("srgb") && section.has("xyz")) {
      reading_.error(value, "spectrum-form", "a colour is either \"xyz\" or \"srgb\"; leave one out");
      return std::nullopt;
    }
    const core::Value& given = *section.find(name);
    if (!isFraction(role_)) {
      reading_.error(given, "wrong-spectrum",
                     fmt::format("a colour stands for a reflectance; \"{}\" is none", key_.name));
      return std::nullopt;
    }
    const auto components = readVector(given, {.name = name}, reading_);
    if (!components) return std::nullopt;
    const std::array<double, 3> colour{components->x, components->y, components->z};
    const bool inRange = std::all_of(colour.begin(), colour.end(), [](double c) { return c >= 0 && c <= 1.2; });
    auto reflectance = !inRange              ? std::nullopt
                       : section.has("srgb") ? spectrum::reflectanceFromSrgb(colour)
                                             : spectrum::reflectanceFromXyz(colour);
    if (!reflectance) {
      reading_.error(
          given, "out-of-range",
          fmt::format("no reflectance between 0 and 1 has this colour under D65; \"{}\" values run from 0 to {}", name,
                      section.has("srgb") ? "1" : "about 1, Y = 1 for white"));
    }
    return reflectance;
  }

  const Key& key_;
  Role role_;
  Reading& reading_;
};

}  // namespace

std::optional<SpectralDistribution> readSpectrum(const core::Value& value, const Key& key, Role role,
                                                 Reading& reading) {
  auto result = SpectrumReader(key, role, reading).read(value);
  if (!result) return std::nullopt;
  if (isFraction(role) && result->range().second > 1) {  // files are checked by their reader; this holds for every form
    reading.error(value, "out-of-range", fmt::format("\"{}\" exceeds 1; it lies between 0 and 1", key.name));
    return std::nullopt;
  }
  if (role == Role::source && !(result->integral(spectrum::cie1931().ybar) > 0)) {
    reading.error(value, "dark-spectrum",
                  fmt::format("\"{}\" holds no visible light (360-830 nm): it cannot carry luminous flux", key.name));
    return std::nullopt;
  }
  return result;
}

}  // namespace goniolux::project
