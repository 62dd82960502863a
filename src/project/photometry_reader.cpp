#include "project/photometry_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/closest_name.h"

namespace goniolux::project {
namespace {

using photometry::CosinePowerDistribution;
using photometry::IntensityDistribution;
using photometry::TabulatedDistribution;

/// One diagram as it is stated: angles and candelas, joined by straight lines.
std::optional<std::vector<core::Vec2>> readDiagram(const core::Value& value, const Key& key, Reading& reading) {
  auto diagram = readPairs(value, key, reading);
  if (!diagram) return std::nullopt;
  for (std::size_t i = 0; i < diagram->size(); ++i) {
    const core::Vec2& point = (*diagram)[i];
    const bool ascends = i == 0 || point.x > (*diagram)[i - 1].x;
    if (point.x < 0 || point.x > 180 || point.y < 0 || !ascends) {
      reading.error(
          value.array()[i], "out-of-range",
          "a diagram is a list of [gamma, cd] with gamma ascending from 0 to 180 degrees and cd of at least 0");
      return std::nullopt;
    }
  }
  if (diagram->size() < 2) {
    reading.error(value, "out-of-range", "a diagram needs at least two angles");
    return std::nullopt;
  }
  return diagram;
}

double valueAt(const std::vector<core::Vec2>& diagram, double gamma) {
  const auto next =
      std::find_if(diagram.begin(), diagram.end(), [&](const core::Vec2& point) { return point.x >= gamma; });
  if (next == diagram.end()) return 0;
  if (next == diagram.begin()) return next->x == gamma ? next->y : 0;
  const core::Vec2 &a = *(next - 1), &b = *next;
  return a.y + (b.y - a.y) * (gamma - a.x) / (b.x - a.x);
}

/// The paper's goniometric diagrams: one is turned about the aim, two are joined bilinearly in the angle C.
std::shared_ptr<const IntensityDistribution> readGoniometric(const core::Value& value, Reading& reading) {
  SectionReader section(value, goniometricSection(), reading);
  if (section.failed()) return nullptr;
  std::vector<std::vector<core::Vec2>> diagrams;
  for (const char* plane : {"c0", "c90"}) {
    if (!section.has(plane)) continue;
    auto diagram = readDiagram(*section.find(plane), *goniometricSection().find(plane), reading);
    if (!diagram) return nullptr;
    diagrams.push_back(std::move(*diagram));
  }
  std::vector<double> gammas;
  for (const auto& diagram : diagrams) {
    for (const core::Vec2& point : diagram) gammas.push_back(point.x);
  }
  std::sort(gammas.begin(), gammas.end());
  gammas.erase(std::unique(gammas.begin(), gammas.end()), gammas.end());
  std::vector<double> candelas;
  for (const auto& diagram : diagrams) {
    for (const double gamma : gammas) candelas.push_back(valueAt(diagram, gamma));
  }
  std::vector<double> planes{0};
  if (diagrams.size() == 2) planes.push_back(90);
  return std::make_shared<TabulatedDistribution>(photometry::PhotometryType::c, planes, gammas, candelas);
}

class PhotometryReader {
 public:
  PhotometryReader(SectionReader& luminaire, Reading& reading) : luminaire_(luminaire), reading_(reading) {}

  std::optional<LuminairePhotometry> read() {
    const core::Value* given = luminaire_.find("photometry");
    const auto flux = luminaire_.number("flux");
    const auto lampFlux = luminaire_.number("lamp_flux");
    if (!given || (luminaire_.has("flux") && !flux) || (luminaire_.has("lamp_flux") && !lampFlux)) return std::nullopt;
    const bool known = given->isString() ? readNamed(*given) : readObject(*given);
    if (!known || !readFlux(*given, flux, lampFlux)) return std::nullopt;
    return result_;
  }

 private:
  bool readNamed(const core::Value& given) {
    result_.name = given.string();
    if (result_.name == "diffuse") return true;
    if (result_.name == "cosine") {
      result_.distribution = std::make_shared<CosinePowerDistribution>(1.0, 1.0);
      return true;
    }
    if (result_.name == "isotropic") {
      result_.distribution = CosinePowerDistribution::isotropic(1.0);
      return true;
    }
    const std::string closest = core::closestName(result_.name, builtInPhotometry());
    const auto path = reading_.file(given, Library::luminaires,
                                    closest.empty() ? "" : fmt::format("; or did you mean \"{}\"?", closest));
    result_.file = path ? reading_.photometricFile(*path) : nullptr;
    if (!result_.file) return false;
    result_.distribution = result_.file->distribution;
    return true;
  }

  bool readObject(const core::Value& given) {
    if (!given.isObject()) {
      reading_.error(given, "wrong-type",
                     fmt::format("\"photometry\" is a file, one of {}, or {{ \"cosine_power\": n }}",
                                 fmt::join(builtInPhotometry(), ", ")));
      return false;
    }
    SectionReader section(given, photometrySection(), reading_);
    if (section.failed()) return false;
    if (given.object().size() != 1) {
      reading_.error(given, "photometry-form",
                     "photometry is either { \"cosine_power\": n } or { \"goniometric\": {…} }");
      return false;
    }
    if (const core::Value* goniometric = section.find("goniometric")) {
      result_.name = "goniometric";
      result_.distribution = readGoniometric(*goniometric, reading_);
    } else if (const auto power = section.number("cosine_power")) {
      result_.name = fmt::format("cosine^{}", *power);
      result_.distribution = std::make_shared<CosinePowerDistribution>(1.0, *power);
    }
    return result_.distribution != nullptr;
  }

  bool readFlux(const core::Value& given, std::optional<double> flux, std::optional<double> lampFlux) {
    if (flux && lampFlux) {
      luminaire_.refuse("lamp_flux", "flux-form",
                        "give \"flux\" (of the luminaire) or \"lamp_flux\" (of its lamps), not both");
      return false;
    }
    const bool hasCandelas = result_.file || result_.name == "goniometric";
    if (!hasCandelas && !flux) {
      reading_.error(given, "missing-key", fmt::format("photometry \"{}\" needs \"flux\" in lm", result_.name));
      return false;
    }
    if (lampFlux) return scaleByLamps(*lampFlux);
    const double own = result_.distribution ? result_.distribution->flux() : 0;
    if (!flux) {
      result_.flux_lm = own;
      return true;
    }
    result_.flux_lm = *flux;
    if (!result_.distribution) return true;
    if (!(own > 0)) {
      luminaire_.refuse("flux", "dark-photometry",
                        "the distribution is 0 cd in every direction: no factor makes flux of it");
      return false;
    }
    result_.scale = *flux / own;
    return true;
  }

  bool scaleByLamps(double lampFlux) {
    if (!result_.file || result_.file->absolute || !result_.file->declaredLumens) {
      luminaire_.refuse("lamp_flux", "flux-form",
                        result_.file
                            ? "the photometric file is absolute: it knows no lamp lumens; give \"flux\" instead"
                            : "\"lamp_flux\" goes with a photometric file; give \"flux\" instead");
      return false;
    }
    if (!(*result_.file->declaredLumens > 0)) {
      luminaire_.refuse("lamp_flux", "flux-form",
                        "the photometric file declares no lamp lumens; give \"flux\" instead");
      return false;
    }
    result_.scale = lampFlux / *result_.file->declaredLumens;
    result_.flux_lm = result_.distribution->flux() * result_.scale;
    return true;
  }

  SectionReader& luminaire_;
  Reading& reading_;
  LuminairePhotometry result_;
};

}  // namespace

std::optional<LuminairePhotometry> readPhotometry(SectionReader& luminaire, Reading& reading) {
  return PhotometryReader(luminaire, reading).read();
}

}  // namespace goniolux::project
