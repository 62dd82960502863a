// Film recorders in device files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "display/device.h"
#include "display/device_section.h"
#include "display/film.h"
#include "spectrum/cie_data.h"

namespace goniolux::display {
namespace {

using core::Value;
using spectrum::SpectralDistribution;

class FilmReader {
 public:
  FilmReader(const DeviceSection& section, Film& film) : section_(section), film_(film) {}

  void read(const Value& root) {
    section_.checkKeys(root, {"format", "version", "kind", "name", "source", "white_cd_m2", "black_cd_m2",
                              "flare_cd_m2", "codes", "recorder", "film", "print", "lamp"});
    if (const Value* codes = object(root, "codes")) {
      section_.checkKeys(*codes, {"bits", "base", "density_per_code"});
      film_.bits = static_cast<int>(section_.number(*codes, "bits", 10, 8, 16));
      film_.baseCode = static_cast<int>(section_.number(*codes, "base", 95, 0, 65535));
      film_.densityPerCode = section_.number(*codes, "density_per_code", 0.002, 1e-5, 0.1);
      if (film_.baseCode >= film_.codeCount())
        section_.complain(*codes, "range", "\"base\" must be a code of so many bits");
    }
    if (const Value* recorder = object(root, "recorder")) {
      section_.checkKeys(*recorder, {"phosphors", "filters"});
      film_.phosphors = three(*recorder, "phosphors", "red", "green", "blue");
      film_.filters = three(*recorder, "filters", "red", "green", "blue");
    }
    const Value* film = object(root, "film");
    const Value* print = root.find("print") != nullptr ? object(root, "print") : nullptr;
    film_.reversal = root.find("print") == nullptr;
    if (film != nullptr) {
      std::vector<std::string> known{"sensitivities", "curve"};
      if (film_.reversal) known.insert(known.end(), {"dyes", "base"});
      section_.checkKeys(*film, known);
      film_.sensitivities = three(*film, "sensitivities", "red", "green", "blue");
      film_.exposed = curves(*film, film_.reversal);
      if (film_.reversal) readDyes(*film);
    }
    if (print != nullptr) {
      section_.checkKeys(*print, {"curve", "dyes", "base"});
      film_.print = curves(*print, false);
      readDyes(*print);
    }
    if (root.find("lamp") == nullptr)
      section_.complain(root, "missing-key", "key \"lamp\" is missing: the light that projects the film");
    else
      film_.lamp = spectrum(*root.find("lamp"), "lamp");
  }

 private:
  const Value* object(const Value& parent, const char* key) const {
    return section_.member(parent, key, Value::Kind::object, "an object");
  }

  void readDyes(const Value& film) {
    film_.dyes = three(film, "dyes", "cyan", "magenta", "yellow");
    film_.base = film.find("base") != nullptr ? spectrum(*film.find("base"), "base") : SpectralDistribution::flat(0);
  }

  Film::Spectra three(const Value& parent, const char* key, const char* first, const char* second,
                      const char* third) const {
    Film::Spectra spectra;
    const Value* group = object(parent, key);
    if (group == nullptr) return spectra;
    section_.checkKeys(*group, {first, second, third});
    const char* names[] = {first, second, third};
    for (std::size_t i = 0; i < 3; ++i) {
      const Value* each = group->find(names[i]);
      if (each == nullptr)
        section_.complain(*group, "missing-key", fmt::format("key \"{}\" is missing", names[i]));
      else
        spectra[i] = spectrum(*each, names[i]);
    }
    return spectra;
  }

  // A number, { "from", "step", "values" }, { "blackbody": kelvin } or the name of an illuminant.
  SpectralDistribution spectrum(const Value& value, const char* key) const {
    const auto flat = SpectralDistribution::flat(1);
    if (value.isNumber() && value.number() >= 0 && value.number() < 100)
      return SpectralDistribution::flat(value.number());
    if (value.isString()) {
      const auto found = spectrum::illuminant(value.string());
      if (!found) section_.complain(value, "spectrum", fmt::format("there is no illuminant \"{}\"", value.string()));
      return found.value_or(flat);
    }
    if (value.isObject() && value.find("blackbody") != nullptr) {
      section_.checkKeys(value, {"blackbody"});
      return spectrum::blackbody(std::clamp(section_.number(value, "blackbody", 3200, 1000, 25000), 1000.0, 25000.0));
    }
    if (value.isObject() && value.find("values") != nullptr) {
      section_.checkKeys(value, {"from", "step", "values"});
      const double from = section_.number(value, "from", 380, 200, 1000),
                   step = section_.number(value, "step", 10, 0.1, 100);
      const Value* values = section_.member(value, "values", Value::Kind::array, "a list of numbers");
      std::vector<SpectralDistribution::Sample> samples;
      if (values != nullptr) {
        for (const Value& each : values->array()) {
          if (!each.isNumber() || !(each.number() >= 0 && each.number() < 1e6)) {
            section_.complain(each, "spectrum", "values must be numbers, at least 0");
            return flat;
          }
          samples.push_back({from + step * static_cast<double>(samples.size()), each.number()});
        }
      }
      if (samples.size() >= 2 && step > 0)
        return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::hold);
    }
    section_.complain(value, "spectrum",
                      fmt::format("\"{}\" must be a spectrum: {{ \"from\": nm, \"step\": nm, \"values\": [...] }}, {{ "
                                  "\"blackbody\": K }}, the name of an illuminant, or a number",
                                  key));
    return flat;
  }

  // "curve": [[log exposure, density], …] for all layers, or { "red": …, "green": …, "blue": … }.
  std::array<Film::Curve, 3> curves(const Value& film, bool falls) const {
    std::array<Film::Curve, 3> result;
    result.fill({{0, 0}, {1, 1}});
    const Value* value = film.find("curve");
    if (value == nullptr) {
      section_.complain(film, "missing-key", "key \"curve\" is missing: [[log10 exposure, density], ...]");
    } else if (value->isObject()) {
      section_.checkKeys(*value, {"red", "green", "blue"});
      const char* names[] = {"red", "green", "blue"};
      for (std::size_t i = 0; i < 3; ++i)
        if (const Value* each = section_.member(*value, names[i], Value::Kind::array, "a list of pairs"))
          result[i] = curve(*each, falls);
    } else {
      result.fill(curve(*value, falls));
    }
    return result;
  }

  Film::Curve curve(const Value& value, bool falls) const {
    const Film::Curve line{{0, 0}, {1, 1}};
    Film::Curve points;
    if (!value.isArray() || value.array().size() < 2) {
      section_.complain(value, "curve", "a curve is a list of at least two pairs [log10 exposure, density]");
      return line;
    }
    for (const Value& each : value.array()) {
      const bool pair =
          each.isArray() && each.array().size() == 2 && each.array()[0].isNumber() && each.array()[1].isNumber();
      if (!pair) {
        section_.complain(each, "curve", "every point of a curve is a pair [log10 exposure, density]");
        return line;
      }
      const double x = each.array()[0].number(), y = each.array()[1].number();
      const bool ascends =
          points.empty() || (x > points.back().first && (falls ? y < points.back().second : y > points.back().second));
      if (!ascends || !(std::abs(x) < 20) || !(std::abs(y) < 20)) {
        section_.complain(each, "curve",
                          falls ? "exposures must ascend and densities of a reversal film fall from point to point"
                                : "exposures and densities must ascend from point to point");
        return line;
      }
      points.emplace_back(x, y);
    }
    if (falls) {  // kept as both ascending: of the exposure that is missing
      std::reverse(points.begin(), points.end());
      for (auto& [x, y] : points) x = -x;
    }
    return points;
  }

  const DeviceSection& section_;
  Film& film_;
};

}  // namespace

void readFilm(const Value& root, const DeviceSection& section, Device& device) {
  auto film = std::make_shared<Film>();
  FilmReader(section, *film).read(root);
  if (section.hasErrors()) return;
  const auto chromaticityOf = [](const core::Vec3& xyz) { return spectrum::chromaticity({xyz.x, xyz.y, xyz.z}); };
  device.film = film;
  const core::Mat3 primaries = compositePrimaries(*film);
  const core::Vec3 white = primaries * core::Vec3(1);
  device.red = chromaticityOf(primaries[0]);
  device.green = chromaticityOf(primaries[1]);
  device.blue = chromaticityOf(primaries[2]);
  device.white = chromaticityOf(white);
  if (!std::isfinite(device.red.x + device.green.x + device.blue.x + device.white.x) || !(device.white.y > 0))
    section.complain(root, "film",
                     "these phosphors, filters, sensitivities and dyes make no colours; check their spectra");
}

}  // namespace goniolux::display
