#include "display/exposure.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

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

double logAverageLuminance(const image::XyzImage& image) {
  double sum = 0;
  std::size_t count = 0;
  for (const float luminance : image.y) {
    if (!(luminance > 0) || !std::isfinite(luminance)) continue;
    sum += std::log(luminance);
    ++count;
  }
  return count > 0 ? std::exp(sum / static_cast<double>(count)) : 0;
}

Exposure automaticExposure(const image::XyzImage& image, double stops) {
  const double average = logAverageLuminance(image);
  if (average == 0) return {1, "automatic: the image is black"};
  return {average / middleGrey / std::exp2(stops),
          fmt::format("automatic: log-average {:.4g} cd/m2 at 18 %{}", average,
                      stops != 0 ? fmt::format(", {:+.4g} stops", stops) : "")};
}

Exposure cameraExposure(double ev100) {
  return {0.125 * std::exp2(ev100) / middleGrey, fmt::format("EV {:.4g} at ISO 100", ev100)};
}

Exposure whiteAt(double white_cd_m2) {
  return {white_cd_m2, "white given"};
}

Exposure exposureFrom(const std::string& text, const image::XyzImage& image) {
  if (text == "auto") return automaticExposure(image);
  const bool automatic = text.rfind("auto", 0) == 0 && text.size() > 5 && (text[4] == '+' || text[4] == '-');
  const auto value = number(automatic ? std::string_view(text).substr(4) : std::string_view(text));
  if (!value) {
    throw core::InputError(
        {}, "exposure",
        fmt::format("'{}' is no exposure; give auto, auto+1 (stops brighter), auto-1, or a number (EV at ISO 100)",
                    text));
  }
  return automatic ? automaticExposure(image, *value) : cameraExposure(*value);
}

}  // namespace goniolux::display
