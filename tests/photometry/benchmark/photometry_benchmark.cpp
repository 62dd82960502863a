// Reading, checking and integrating a photometric file (issue: under 5 ms), from bytes in memory; and a look at the
// distribution. Run: build/release/bin/benchmark_photometry
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "core/document.h"
#include "photometry/flux_check.h"
#include "photometry/photometric_file.h"

namespace {

using namespace goniolux;

const std::string folder = std::string(GONIOLUX_SOURCE_DIR) + "/luminaires/";

void readCheckIntegrate(benchmark::State& state, const std::string& name) {
  const std::string bytes = core::readFile(folder + name);
  for (auto unused : state) {
    (void)unused;
    const photometry::PhotometricFile file = photometry::readPhotometry(bytes, name);
    benchmark::DoNotOptimize(photometry::zonalConstantFlux(*file.distribution));
    benchmark::DoNotOptimize(file.distribution->flux());
  }
  state.counters["bytes"] = static_cast<double>(bytes.size());
}

void lookUp(benchmark::State& state, const std::string& name) {
  const photometry::PhotometricFile file = photometry::readPhotometricFile(folder + name);
  double angle = 0.1;
  for (auto unused : state) {
    (void)unused;
    angle += 0.618;
    const core::Vec3 direction(std::sin(angle) * std::cos(2 * angle), std::sin(angle) * std::sin(2 * angle),
                               std::cos(angle));
    benchmark::DoNotOptimize(file.distribution->intensity(direction));
  }
}

BENCHMARK_CAPTURE(readCheckIntegrate, one_plane_lm63, "panel-600.ies")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readCheckIntegrate, quadrant_eulumdat, "linear-pendant.ldt")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readCheckIntegrate, full_circle_lm63, "track-spot.ies")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readCheckIntegrate, type_b_lm63, "floodlight-b.ies")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readCheckIntegrate, quadrant_tm33, "traced-opal-panel.xml")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lookUp, full_circle, "track-spot.ies");

}  // namespace

BENCHMARK_MAIN();
