// Mappings that multiply every luminance by one factor: photographic exposure, and none at all.
#include <fmt/format.h>

#include <cmath>

#include "core/diagnostics.h"
#include "core/text.h"
#include "display/mapping_types.h"

namespace goniolux::display {
namespace {

[[noreturn]] void refuse(std::string message) {
  throw core::InputError({}, "mapping", std::move(message));
}

ToneMap scaled(const Exposure& exposure) {
  ToneMap map;
  map.white_cd_m2 = exposure.white_cd_m2;
  map.method = exposure.method;
  map.curve = std::make_shared<ToneCurve>([&](double luminance) { return luminance / exposure.white_cd_m2; });
  return map;
}

// "0.01", "1/100".
double seconds(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto above = core::parseNumber(text.substr(0, slash));
  const auto below = slash == std::string::npos ? 1 : core::parseNumber(text.substr(slash + 1));
  if (!above || !below || !(*above > 0 && *below > 0) || !std::isfinite(*above / *below))
    refuse(fmt::format("'{}' is no shutter time; give seconds, such as 0.5 or 1/60", text));
  return *above / *below;
}

// Camera settings to EV at ISO 100: EV = log2(N^2 / t) - log2(S / 100) — ISO 2720.
ToneMap makeLinear(const MappingTask& task, const core::Arguments& arguments) {
  const double white = numberOf(arguments, "white"), aperture = numberOf(arguments, "aperture");
  const std::string& shutter = textOf(arguments, "shutter");
  if ((aperture > 0) != !shutter.empty()) refuse("a camera's setting needs both aperture and shutter");
  if (aperture > 0) {
    if (white > 0 || textOf(arguments, "ev") != "auto") refuse("give a camera's setting, or ev, or white: one of them");
    const double iso = numberOf(arguments, "iso"), time = seconds(shutter);
    Exposure exposure = cameraExposure(std::log2(aperture * aperture / time * 100 / iso));
    exposure.method = fmt::format("f/{:g}, {} s, ISO {:g} ({})", aperture, shutter, iso, exposure.method);
    return scaled(exposure);
  }
  if (white > 0) {
    if (textOf(arguments, "ev") != "auto") refuse("give ev, or white: one of them");
    return scaled(whiteAt(white));
  }
  return scaled(exposureFrom(textOf(arguments, "ev"), task.statistics));
}

ToneMap makeAbsolute(const MappingTask& task, const core::Arguments&) {
  if (!(task.white_cd_m2 > 0))
    refuse(
        "luminances can be shown as they are only by a device whose luminance is known: add \"white_cd_m2\" to its "
        "file, or choose another mapping");
  ToneMap map = scaled(whiteAt(task.white_cd_m2));
  map.method = fmt::format("none: every luminance as it is, up to {:g} cd/m2", task.white_cd_m2);
  return map;
}

}  // namespace

MappingType linearMapping() {
  return {"linear",
          "one factor for the whole picture, as a camera exposes",
          "ISO 2720; automatic: Reinhard et al., SIGGRAPH 2002",
          {mappingText("ev", "auto", "auto, auto+1, auto-1 (stops), or EV at ISO 100"),
           mappingNumber("white", "0", 0, true, "luminance shown as white, cd/m2; 0: not used"),
           mappingNumber("iso", "100", 0, false, "speed of the film, with shutter and aperture"),
           mappingText("shutter", "", "seconds: 0.5, 1/60"), mappingNumber("aperture", "0", 0, true, "f-number")},
          makeLinear};
}

MappingType absoluteMapping() {
  return {"none", "luminances as they are: the picture has the scene's cd/m2", "", {}, makeAbsolute};
}

}  // namespace goniolux::display
