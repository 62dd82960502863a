// Tumblin & Rushmeier's tone reproduction: the brightness that an observer adapted to the scene sees, seen by an
// observer adapted to the display — IEEE Computer Graphics and Applications 13(6), 1993, after Stevens and Stevens
// (1963).
#include <fmt/format.h>

#include <cmath>

#include "display/mapping_types.h"

namespace goniolux::display {
namespace {

// The model counts luminances in lamberts: 1 L = 10^4 / pi cd/m2.
constexpr double lambert_cd_m2 = 10000 / core::pi;

// Brightness = 10^beta * L^alpha / K for an observer adapted to La.
struct Brightness {
  double alpha, beta;
};
Brightness brightness(double adaptation_cd_m2) {
  const double logLa = std::log10(adaptation_cd_m2 / lambert_cd_m2);
  return {0.4 * logLa + 2.92, -0.4 * logLa * logLa - 2.584 * logLa + 2.0208};
}

ToneMap make(const MappingTask& task, const core::Arguments& arguments) {
  // A monitor of the usual kind stands for a device whose luminance is not known.
  const double white = task.white_cd_m2 > 0 ? task.white_cd_m2 : 100;
  const double contrast = numberOf(arguments, "contrast");
  const double displayAdaptation = white / std::sqrt(contrast);
  const double sceneAdaptation = task.statistics.logAverage_cd_m2 > 0 ? task.statistics.logAverage_cd_m2 : 1;
  const Brightness scene = brightness(sceneAdaptation), display = brightness(displayAdaptation);
  ToneMap map;
  map.curve = std::make_shared<ToneCurve>([&](double luminance) {
    // Equal brightness: 10^beta_rw L^alpha_rw = 10^beta_d Ld^alpha_d. The least luminance of the display is the
    // device's black and flare, which its model takes away.
    const double shown = std::pow(luminance / lambert_cd_m2, scene.alpha / display.alpha) *
                         std::pow(10.0, (scene.beta - display.beta) / display.alpha) * lambert_cd_m2;
    return shown / white;
  });
  map.method = fmt::format("Tumblin-Rushmeier: adapted to {:.4g} cd/m2 there, to {:.4g} cd/m2 here", sceneAdaptation,
                           displayAdaptation);
  return map;
}

}  // namespace

MappingType tumblinRushmeierMapping() {
  return {"tumblin-rushmeier",
          "equal brightness for eyes adapted to the scene and to the display: dim rooms look dim",
          "Tumblin and Rushmeier, IEEE CG&A 13(6), 1993",
          {mappingNumber("contrast", "35", 1, false,
                         "largest contrast of the display; its adaptation is white over the root of this")},
          make};
}

}  // namespace goniolux::display
