// Reinhard's photographic mapping: middle grey by the log-average luminance, highlights rolled off, the same everywhere
// or by dodging and burning — Reinhard, Stark, Shirley, Ferwerda, SIGGRAPH 2002, equations 2, 4 and 9.
#include <fmt/format.h>

#include <cmath>

#include "display/dodging.h"
#include "display/mapping_types.h"

namespace goniolux::display {
namespace {

// Each pixel's luminance is divided by 1 + that of its surroundings; what is shown is worked out here, and the curve
// has nothing left to do.
void dodge(ToneMap& map, const MappingTask& task, double key, double scale, double white, double sharpness) {
  image::XyzImage& seen = map.seen.emplace(task.image);
  std::vector<float> scaled = seen.y;
  for (float& value : scaled) value *= static_cast<float>(scale);
  const std::vector<float> around = localAdaptation(scaled, seen.width, seen.height, {key, sharpness});
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    const auto factor = static_cast<float>(scale * (1 + static_cast<double>(scaled[i]) / (white * white)) /
                                           (1 + static_cast<double>(around[i])));
    seen.x[i] *= factor, seen.y[i] *= factor, seen.z[i] *= factor;
  }
  map.curve = std::make_shared<ToneCurve>([](double luminance) { return luminance; });
}

ToneMap make(const MappingTask& task, const core::Arguments& arguments) {
  const double key = numberOf(arguments, "key"), given = numberOf(arguments, "white");
  const double average = task.statistics.logAverage_cd_m2 > 0 ? task.statistics.logAverage_cd_m2 : 1;
  const double scale = key / average;
  const bool local = isOn(arguments, "local");
  ToneMap map;
  map.white_cd_m2 = given > 0 ? given : std::max(task.statistics.largest_cd_m2, average / key);
  const double white = map.white_cd_m2 * scale;  // L_white, the smallest luminance that becomes white
  if (local) {
    dodge(map, task, key, scale, white, numberOf(arguments, "sharpness"));
  } else {
    map.curve = std::make_shared<ToneCurve>([&](double luminance) {
      const double l = luminance * scale;
      return l * (1 + l / (white * white)) / (1 + l);
    });
  }
  map.method = fmt::format("Reinhard{}: key {:g}, log-average {:.4g} cd/m2, white {:.4g} cd/m2",
                           local ? ", dodging and burning" : "", key, average, map.white_cd_m2);
  return map;
}

}  // namespace

MappingType reinhardMapping() {
  return {"reinhard",
          "photographic: middle grey by the average, highlights rolled off",
          "Reinhard et al., SIGGRAPH 2002",
          {mappingNumber("key", "0.18", 0, false, "what the log-average luminance is shown as before highlights bend"),
           mappingNumber("white", "0", 0, true, "luminance that becomes white, cd/m2; 0: the largest of the image"),
           mappingSwitch("local",
                         "dodging and burning: highlights are rolled off by what is about them, which keeps "
                         "detail in lamps and windows"),
           mappingNumber("sharpness", "8", 0, true, "of local: how soon an edge ends the surroundings of a pixel")},
          make};
}

}  // namespace goniolux::display
