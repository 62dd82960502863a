#include "pipeline/render_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.h"
#include "pipeline/render.h"
#include "spectrum/cie_data.h"

namespace goniolux::pipeline {
namespace {

// The pixel loop keeps three of the four channels of a response.
constexpr std::size_t planes = 3;
// The pixel loop decides in cd/m2: spectral radiance is carried as the luminance that 100 nm of it would have at best.
constexpr double carried = 100 * spectrum::maximumLuminousEfficacy;

// Each channel of the response sees one wavelength: spectral radiance for luminance 1 of the source.
spectrum::SpectralQuadrature quadratureFor(const std::vector<spectrum::SpectralDistribution>& sources,
                                           const std::vector<double>& wavelengths, double step_nm) {
  spectrum::SpectralQuadrature quadrature;
  quadrature.scheme = "channels";
  quadrature.wavelengths = wavelengths;
  quadrature.values = spectrum::NodeValues::sampled;
  for (const auto& source : sources) {
    const double luminous = spectrum::maximumLuminousEfficacy * source.integral(spectrum::cie1931().ybar);
    std::vector<spectrum::Response> weights(wavelengths.size(), spectrum::Response{});
    for (std::size_t k = 0; k < wavelengths.size(); ++k) {
      const double mean = source.integral(wavelengths[k] - 0.5 * step_nm, wavelengths[k] + 0.5 * step_nm) / step_nm;
      weights[k][k] = luminous > 0 ? carried * mean / luminous : 0;
    }
    quadrature.weights.push_back(std::move(weights));
  }
  return quadrature;
}

}  // namespace

std::vector<double> SpectralRange::wavelengths() const {
  std::vector<double> list;
  for (double nm = from_nm; nm <= to_nm + 1e-6 * step_nm; nm += step_nm) list.push_back(nm);
  return list;
}

SpectralRange spectralRangeFrom(const std::string& text) {
  core::TextScanner scanner(text);
  std::vector<double> numbers;
  while (const auto word = scanner.word(":")) {
    const auto value = core::parseNumber(word->text);
    if (!value || !std::isfinite(*value)) break;
    numbers.push_back(*value);
  }
  const bool fits = scanner.atEnd() && numbers.size() == 3 && numbers[0] >= 300 && numbers[1] <= 1000 &&
                    numbers[1] >= numbers[0] && numbers[2] > 0 && (numbers[1] - numbers[0]) / numbers[2] < 128;
  if (!fits)
    throw core::InputError(
        {"--channels", 0, 0}, "channels",
        fmt::format("'{}' are no wavelengths; give FROM:TO:STEP in nm, such as 400:700:10, at most 128 "
                    "from 300 to 1000 nm",
                    text));
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<image::SpectralChannel> renderSpectrum(const project::Project& project, const Engine& engine,
                                                   const scene::View& view, std::uint64_t key,
                                                   const SpectralRange& range, core::ProgressSink& progress,
                                                   const core::Keeping& keeping) {
  const std::vector<double> all = range.wavelengths();
  std::vector<image::SpectralChannel> channels;
  for (std::size_t first = 0; first < all.size() && !progress.cancelled(); first += planes) {
    const std::vector<double> some(all.begin() + static_cast<std::ptrdiff_t>(first),
                                   all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), first + planes)));
    progress.note(fmt::format("{}: {:g} to {:g} nm", view.name, some.front(), some.back()));
    const spectrum::SpectralQuadrature quadrature = quadratureFor(engine.world.sourceSpectra, some, range.step_nm);
    const auto solver = solver::findSolverType(engine.plan.solver)
                            ->make({engine.world, engine.tracer, quadrature, engine.plan.accuracy, engine.plan.tree});
    viewing::ImageEstimate estimate = viewing::renderView(
        *solver, view, engine.world.origin, key, pixelAccuracyOf(project.settings),
        std::numeric_limits<double>::infinity(), progress, {}, keeping.part(fmt::format("channels {}", first)));
    image::XyzImage& image = estimate.image;
    std::vector<float>* values[] = {&image.x, &image.y, &image.z};
    std::vector<float>* halfWidths[] = {&estimate.halfWidthX, &image.halfWidth, &estimate.halfWidthZ};
    for (std::size_t k = 0; k < some.size(); ++k) {
      image::SpectralChannel& channel =
          channels.emplace_back(some[k], std::move(*values[k]), std::move(*halfWidths[k]));
      for (std::size_t i = 0; i < channel.values.size(); ++i) {
        channel.values[i] /= static_cast<float>(carried);
        channel.halfWidth[i] /= static_cast<float>(carried);
      }
    }
  }
  return channels;
}

}  // namespace goniolux::pipeline
