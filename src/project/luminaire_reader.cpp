#include "project/luminaire_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "project/opening_reader.h"
#include "project/photometry_reader.h"
#include "project/section_reader.h"
#include "project/spectrum_reader.h"
#include "project/transform_reader.h"

namespace goniolux::project {
namespace {

// Below an angle of about 1e-6 rad the perpendicular part of c0 is rounding noise.
bool parallel(const core::Vec3& a, const core::Vec3& b) {
  return glm::length(glm::cross(a, b)) < 1e-6;
}

struct Array {
  std::array<int, 2> counts{1, 1};
  core::Vec3 u{0}, v{0};
};

std::optional<Array> readArray(const core::Value& value, Reading& reading) {
  SectionReader section(value, arraySection(), reading);
  if (!section.isObject()) return std::nullopt;
  const auto counts = section.counts("counts");
  const auto u = section.point("u"), v = section.point("v");
  if (section.failed() || !counts) return std::nullopt;
  const Array array{*counts, u.value_or(core::Vec3(0)), v.value_or(core::Vec3(0))};
  const auto standsStill = [](int count, const core::Vec3& step) { return count > 1 && !(glm::length(step) > 0); };
  for (const char* key : {"u", "v"}) {
    const bool first = key[0] == 'u';
    if (standsStill(array.counts[first ? 0 : 1], first ? array.u : array.v)) {
      section.refuse(
          key, "zero-vector",
          fmt::format("the step \"{}\" of the array is missing or 0: its luminaires would stand in one place", key));
      return std::nullopt;
    }
  }
  return array;
}

class LuminaireReader {
 public:
  LuminaireReader(scene::Environment& environment, Reading& reading) : environment_(environment), reading_(reading) {}

  void read(const core::Value& value, std::size_t number) {
    SectionReader section(value, luminaireSection(), reading_);
    if (!section.isObject()) return;
    scene::Luminaire luminaire;
    luminaire.position = value.position();
    luminaire.type = section.text("name").value_or(fmt::format("luminaire {}", number + 1));
    luminaire.group = section.text("group").value_or(luminaire.type);
    luminaire.maintenance = section.number("maintenance").value_or(1);
    luminaire.dimming = section.number("dimming").value_or(1);
    luminaire.reflectance = section.number("reflectance").value_or(0);
    const auto position = section.point("position");
    const bool placed = readFrame(section, luminaire);
    std::optional<Array> array = Array{};
    if (const core::Value* given = section.find("array")) array = readArray(*given, reading_);
    const auto photometry = readPhotometry(section, reading_);
    readSpectrumKey(section, photometry ? photometry->file : nullptr, luminaire);
    // An unreadable file must not hide what is wrong with a stated shape.
    auto opening =
        readOpening(section.find("shape"), photometry ? photometry->file : nullptr, luminaire.frame, reading_);
    if (!position || !placed || !array || !photometry || !opening) return;
    if (!photometry->distribution && !hasSurface(*opening)) {
      section.refuse(
          "photometry", "opening-form",
          "\"diffuse\" light leaves a surface: give \"shape\", e.g. a tube or a rectangle (or take \"isotropic\")");
      return;
    }
    // An axis that the project states turns along; that of a file's opening comes from the turned frame.
    if (const core::Value* shape = section.find("shape"); shape && shape->isObject())
      opening->axis = rotation(luminaire.frame.aim, turn_) * opening->axis;
    luminaire.opening = *opening;
    luminaire.photometry = photometry->name;
    luminaire.distribution = photometry->distribution;
    luminaire.scale = photometry->scale;
    luminaire.flux_lm = photometry->flux_lm;
    if (photometry->file && photometry->file->tilt && !section.has("flux")) applyTilt(*photometry->file, luminaire);
    luminaire.watts = photometry->file ? photometry->file->inputWatts : 0;
    place(luminaire, *position, *array, section.has("array"));
  }

  /// Names of luminaires whose spectrum is the default.
  [[nodiscard]] const std::vector<std::string>& withoutSpectrum() const { return withoutSpectrum_; }

 private:
  bool readFrame(SectionReader& section, scene::Luminaire& luminaire) {
    const auto aim = section.direction("aim"), c0 = section.direction("c0");
    turn_ = section.number("turn").value_or(0) * core::degree;
    if ((section.has("aim") && !aim) || (section.has("c0") && !c0)) return false;
    if (section.has("rotation") || section.has("tilt")) return readRotationAndTilt(section, luminaire);
    const core::Vec3 forward = aim.value_or(core::Vec3(0, 0, -1));
    core::Vec3 side = c0.value_or(core::Vec3(1, 0, 0));
    if (parallel(forward, side)) {
      if (c0) {
        section.refuse("c0", "parallel",
                       "\"c0\" is parallel to \"aim\"; it must point across, to where the plane C0 lies");
        return false;
      }
      side = {0, 1, 0};
    }
    luminaire.frame = frameOf(forward, side, turn_);
    return true;
  }

  // As a fitting is set on site: turned about the vertical, then tilted towards where its C0 now lies.
  bool readRotationAndTilt(SectionReader& section, scene::Luminaire& luminaire) {
    const double rotated = section.number("rotation").value_or(0) * core::degree;
    const double tilt = section.number("tilt").value_or(0) * core::degree;
    for (const char* other : {"aim", "c0"}) {
      if (!section.has(other)) continue;
      section.refuse(other, "aimed-twice",
                     fmt::format("\"rotation\" and \"tilt\" aim the luminaire; leave out \"{}\", or them", other));
      return false;
    }
    const core::Vec3 across(std::cos(rotated), std::sin(rotated), 0), up(0, 0, 1);
    luminaire.frame =
        frameOf(across * std::sin(tilt) - up * std::cos(tilt), across * std::cos(tilt) + up * std::sin(tilt), turn_);
    return true;
  }

  // LM-63: the lamp's output at the angle at which the luminaire is installed.
  void applyTilt(const photometry::PhotometricFile& file, scene::Luminaire& luminaire) {
    const double tilt = std::acos(std::clamp(-luminaire.frame.aim.z, -1.0, 1.0)) / core::degree;
    const double factor = photometry::tiltFactor(*file.tilt, tilt) / photometry::tiltFactor(*file.tilt, 0);
    if (factor == 1) return;
    luminaire.scale *= factor;
    luminaire.flux_lm *= factor;
    reading_.diagnostics.warning(
        luminaire.position, "tilt-factor",
        fmt::format("\"{}\" is tilted by {:.3g} degrees, where the lamp gives {:.4g} of its light by {}: {:.5g} lm",
                    luminaire.type, tilt, factor, file.file, luminaire.flux_lm));
  }

  void readSpectrumKey(SectionReader& section, const photometry::PhotometricFile* file, scene::Luminaire& luminaire) {
    auto spectrum = spectrum::SpectralDistribution::flat(1);  // CIE E: the choice that favours no colour
    if (const core::Value* given = section.find("spectrum")) {
      auto read = readSpectrum(*given, *luminaireSection().find("spectrum"), spectrum::Role::source, reading_);
      if (!read) return;
      spectrum = std::move(*read);
    } else if (file && file->spectrum) {
      spectrum = *file->spectrum;
    } else {
      withoutSpectrum_.push_back(luminaire.type);
    }
    auto& known = environment_.sourceSpectra;
    const auto found = std::find(known.begin(), known.end(), spectrum);
    luminaire.spectrum = static_cast<std::uint32_t>(found - known.begin());
    if (found == known.end()) known.push_back(std::move(spectrum));
  }

  void place(scene::Luminaire luminaire, const core::Vec3& position, const Array& array, bool isArray) {
    for (int j = 0; j < array.counts[1]; ++j) {
      for (int i = 0; i < array.counts[0]; ++i) {
        luminaire.name = isArray ? fmt::format("{}[{},{}]", luminaire.type, i, j) : luminaire.type;
        luminaire.center = position + static_cast<double>(i) * array.u + static_cast<double>(j) * array.v;
        environment_.luminaires.push_back(luminaire);
      }
    }
  }

  scene::Environment& environment_;
  Reading& reading_;
  std::vector<std::string> withoutSpectrum_;
  double turn_ = 0;
};

void checkNames(const std::vector<scene::Luminaire>& luminaires, Reading& reading) {
  std::map<std::string, const scene::Luminaire*> names;
  for (const scene::Luminaire& luminaire : luminaires) {
    const auto [known, isNew] = names.try_emplace(luminaire.name, &luminaire);
    const bool sameEntry = known->second->position.line == luminaire.position.line &&
                           known->second->position.column == luminaire.position.column;
    if (isNew || sameEntry) continue;
    reading.diagnostics.error(luminaire.position, "duplicate-name",
                              fmt::format("another luminaire (line {}) is named \"{}\" too; give each its own name",
                                          known->second->position.line, luminaire.name));
  }
}

bool hasColour(const scene::Environment& environment) {
  return std::any_of(environment.materials.begin(), environment.materials.end(),
                     [](const material::Material& material) {
                       return std::any_of(material.spectra.begin(), material.spectra.end(),
                                          [](const auto& entry) { return !entry.second.isFlat(); });
                     });
}

}  // namespace

photometry::LuminaireFrame frameOf(const core::Vec3& aim, const core::Vec3& c0, double turn) {
  const core::Vec3 across = glm::normalize(c0 - glm::dot(c0, aim) * aim);
  photometry::LuminaireFrame frame;
  frame.aim = aim;
  frame.c0 = turn == 0 ? across : glm::normalize(rotation(aim, turn) * across);
  frame.c90 = glm::cross(frame.c0, aim);
  return frame;
}

void readLuminaires(const core::Value& section, scene::Environment& environment, Reading& reading) {
  if (!section.isArray() || section.array().empty()) {
    reading.error(section, "wrong-type", "\"luminaires\" must be a list with at least one luminaire");
    return;
  }
  LuminaireReader reader(environment, reading);
  for (std::size_t i = 0; i < section.array().size(); ++i) reader.read(section.array()[i], i);
  checkNames(environment.luminaires, reading);
  if (!reader.withoutSpectrum().empty() && hasColour(environment)) {
    reading.warning(
        section, "default-spectrum",
        fmt::format("no \"spectrum\" is stated for {}: equal energy (CIE E) is taken, which colours depend on",
                    fmt::join(reader.withoutSpectrum(), ", ")));
  }
}

}  // namespace goniolux::project
