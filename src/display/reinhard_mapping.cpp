// Reinhard's photographic mapping, global form: middle grey by the log-average luminance, highlights rolled off —
// Reinhard, Stark, Shirley, Ferwerda, SIGGRAPH 2002, equations 2 and 4.
#include <fmt/format.h>

#include <cmath>

#include "display/mapping_types.h"

namespace goniolux::display {
namespace {

ToneMap make(const MappingTask& task, const core::Arguments& arguments) {
  const double key = numberOf(arguments, "key"), given = numberOf(arguments, "white");
  const double average = task.statistics.logAverage_cd_m2 > 0 ? task.statistics.logAverage_cd_m2 : 1;
  const double scale = key / average;
  ToneMap map;
  map.white_cd_m2 = given > 0 ? given : std::max(task.statistics.largest_cd_m2, average / key);
  const double white = map.white_cd_m2 * scale;  // L_white, the smallest luminance that becomes white
  map.curve = std::make_shared<ToneCurve>([&](double luminance) {
    const double l = luminance * scale;
    return l * (1 + l / (white * white)) / (1 + l);
  });
  map.method =
      fmt::format("Reinhard: key {:g}, log-average {:.4g} cd/m2, white {:.4g} cd/m2", key, average, map.white_cd_m2);
  return map;
}

}  // namespace

MappingType reinhardMapping() {
  return {"reinhard",
          "photographic: middle grey by the average, highlights rolled off",
          "Reinhard et al., SIGGRAPH 2002",
          {mappingNumber("key", "0.18", 0, false, "what the log-average luminance is shown as before highlights bend"),
           mappingNumber("white", "0", 0, true, "luminance that becomes white, cd/m2; 0: the largest of the image")},
          make};
}

}  // namespace goniolux::display
