// Spectral channels of a view: spectral radiance in every pixel at equally spaced wavelengths.
#pragma once

#include <string>
#include <vector>

#include "core/kept_work.h"
#include "image/xyz_image.h"
#include "pipeline/engine.h"
#include "viewing/pixel_loop.h"

namespace goniolux::pipeline {

struct SpectralRange {
  double from_nm = 0, to_nm = 0, step_nm = 0;
  [[nodiscard]] std::vector<double> wavelengths() const;
};

/// "FROM:TO:STEP" ("400:700:10"), at most 128 wavelengths within 300 to 1000 nm. core::InputError for anything else.
SpectralRange spectralRangeFrom(const std::string& text);

/// Renders the view once more for every three wavelengths, with the same random numbers, reflectances and
/// transmittances taken at the wavelength itself, and sources by their mean over a step about it: lines are spread over
/// it. W/(m2 sr nm).
std::vector<image::SpectralChannel> renderSpectrum(const project::Project& project, const Engine& engine,
                                                   const scene::View& view, std::uint64_t key,
                                                   const SpectralRange& range, core::ProgressSink& progress,
                                                   const core::Keeping& keeping = {});

}  // namespace goniolux::pipeline
