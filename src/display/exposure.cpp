#include "display/exposure.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/diagnostics.h"

namespace goniolux::display {
namespace {

constexpr double middleGrey = 0.18;

std::optional<double> number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !(std::abs(value) <= 60)) return std::nullopt;
  return value;
}

}  // namespace

LuminanceStatistics luminanceStatistics(const image::XyzImage& image, const core::Mat3& toRgb) {
  // A histogram over the binary logarithm from 2^-32 to 2^32 cd/m2.
  constexpr int perStop = 64, range = 32;
  std::vector<std::size_t> histogram(2 * range * perStop);
  double sum = 0;
  float largestLuminance = 0;
  std::size_t count = 0;
  const glm::mat3 matrix(toRgb);
  for (std::size_t i = 0; i < image.y.size(); ++i) {
    const float luminance = image.y[i];
    if (!(luminance > 0) || !std::isfinite(luminance + image.x[i] + image.z[i])) continue;
    const glm::vec3 rgb = matrix * glm::vec3(image.x[i], luminance, image.z[i]);
    const float largest = std::max({rgb.x, rgb.y, rgb.z, luminance / 100});  // above 0 for any X and Z
    const float place = (std::log2(largest) + range) * perStop;
    ++histogram[static_cast<std::size_t>(std::clamp(place, 0.0F, static_cast<float>(histogram.size() - 1)))];
    sum += std::log2(luminance);
    largestLuminance = std::max(largestLuminance, luminance);
    ++count;
  }
  if (count == 0) return {};
  std::size_t brighter = 0, bin = histogram.size();
  while (brighter * 20 <= count) brighter += histogram[--bin];
  return {std::exp2(sum / static_cast<double>(count)), std::exp2(static_cast<double>(bin + 1) / perStop - range),
          static_cast<double>(largestLuminance)};
}

Exposure automaticExposure(const LuminanceStatistics& statistics, double stops) {
  const double average = statistics.logAverage_cd_m2;
  if (average == 0) return {1, "automatic: the image is black"};
  const double photographic = average / middleGrey;
  const double white = std::clamp(statistics.bright_cd_m2, photographic, 4 * photographic);
  return {white / std::exp2(stops),
          fmt::format("automatic: log-average {:.4g} cd/m2 at {:.0f} %{}", average, 100 * average / white,
                      stops != 0 ? fmt::format(", {:+.4g} stops", stops) : "")};
}

Exposure cameraExposure(double ev100) {
  return {0.125 * std::exp2(ev100) / middleGrey, fmt::format("EV {:.4g} at ISO 100", ev100)};
}

Exposure whiteAt(double white_cd_m2) {
  return {white_cd_m2, "white given"};
}

Exposure exposureFrom(const std::string& text, const LuminanceStatistics& statistics) {
  if (text == "auto") return automaticExposure(statistics);
  const bool automatic = text.rfind("auto", 0) == 0 && text.size() > 5 && (text[4] == '+' || text[4] == '-');
  const auto value = number(automatic ? std::string_view(text).substr(4) : std::string_view(text));
  if (!value) {
    throw core::InputError(
        {}, "exposure",
        fmt::format("'{}' is no exposure; give auto, auto+1 (stops brighter), auto-1, or a number (EV at ISO 100)",
                    text));
  }
  return automatic ? automaticExposure(statistics, *value) : cameraExposure(*value);
}

}  // namespace goniolux::display
