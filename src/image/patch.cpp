#include "image/patch.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/text.h"
#include "spectrum/colorimetry.h"

namespace goniolux::image {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// Systematic part of Y's half-width, relative; nothing where the image does not say.
std::optional<double> systematicOf(const XyzImage& image) {
  const auto found = image.attributes.find(systematicAttribute);
  if (found == image.attributes.end()) return std::nullopt;
  const auto value = core::parseNumber(found->second);
  return value && *value >= 0 ? value : std::nullopt;
}

std::optional<Measured> colourTemperatureOf(const PatchReading& reading, double duv) {
  // CIE 015: beyond this distance from the Planckian locus the term should not be used.
  if (!(std::abs(duv) <= 0.05) || !(reading.y.value > 0)) return std::nullopt;
  const auto kelvinAt = [](double x, double y) {
    return spectrum::colourTemperature({x / y, 1, (1 - x - y) / y}).kelvin;
  };
  Measured result{kelvinAt(reading.x.value, reading.y.value), 0};
  if (!std::isfinite(reading.x.halfWidth) || !std::isfinite(reading.y.halfWidth))
    return Measured{result.value, unknown};
  for (const double sx : {-1.0, 0.0, 1.0})
    for (const double sy : {-1.0, 0.0, 1.0}) {
      const double x = reading.x.value + sx * reading.x.halfWidth;
      const double y = std::max(1e-3, reading.y.value + sy * reading.y.halfWidth);
      result.halfWidth = std::max(result.halfWidth, std::abs(kelvinAt(x, y) - result.value));
    }
  return result;
}

/// What is read of pixels, by their numbers; those that hold no numbers are counted only.
PatchReading readPixels(const XyzImage& image, const std::vector<std::size_t>& all) {
  std::vector<std::size_t> pixels;
  PatchReading reading;
  for (const std::size_t i : all) {
    if (std::isfinite(image.x[i] + image.y[i] + image.z[i]))
      pixels.push_back(i);
    else
      ++reading.invalid;
  }
  reading.pixels = pixels.size();
  if (pixels.empty()) {
    reading.luminance = reading.x = reading.y = {unknown, unknown};
    reading.least = reading.most = unknown;
    return reading;
  }

  const auto n = static_cast<double>(pixels.size());
  const auto at = [](const std::vector<float>& values, std::size_t i) { return static_cast<double>(values[i]); };
  double X = 0, Y = 0, Z = 0;
  reading.least = reading.most = at(image.y, pixels.front());
  for (const std::size_t i : pixels) {
    X += at(image.x, i) / n;
    Y += at(image.y, i) / n;
    Z += at(image.z, i) / n;
    reading.least = std::min(reading.least, at(image.y, i));
    reading.most = std::max(reading.most, at(image.y, i));
  }
  const spectrum::Chromaticity colour = spectrum::chromaticity({X, Y, Z});
  reading.luminance = {Y, unknown};
  reading.x = {colour.x, unknown};
  reading.y = {colour.y, unknown};

  if (!image.halfWidth.empty()) {
    const auto systematic = systematicOf(image);
    double squares = 0, common = 0;
    for (const std::size_t i : pixels) {
      const double whole = at(image.halfWidth, i);
      const double shared = systematic ? std::min(whole, *systematic * std::abs(at(image.y, i))) : whole;
      squares += (whole - shared) * (whole - shared);
      common += shared;
    }
    reading.luminance.halfWidth = std::sqrt(squares) / n + common / n;
  }
  if (!image.chromaticityX.empty() && !image.chromaticityY.empty() && X + Y + Z > 0) {
    // x = sum of X over sum of S = X + Y + Z: dx = sum (S_i dx_i + (x_i - x) dS_i) / S; within a pixel both parts are
    // taken to go together, from pixel to pixel they are independent.
    double squaresX = 0, squaresY = 0;
    for (const std::size_t i : pixels) {
      const double S = at(image.x, i) + at(image.y, i) + at(image.z, i);
      if (!(S > 0)) continue;
      const double relative =
          image.halfWidth.empty() || !(image.y[i] > 0) ? 0 : at(image.halfWidth, i) / at(image.y, i);
      const double dx = S * (at(image.chromaticityX, i) + std::abs(at(image.x, i) / S - colour.x) * relative);
      const double dy = S * (at(image.chromaticityY, i) + std::abs(at(image.y, i) / S - colour.y) * relative);
      squaresX += dx * dx;
      squaresY += dy * dy;
    }
    reading.x.halfWidth = std::sqrt(squaresX) / (n * (X + Y + Z));
    reading.y.halfWidth = std::sqrt(squaresY) / (n * (X + Y + Z));
  }
  if (X + Y + Z > 0 && colour.y > 0) {
    reading.duv = spectrum::colourTemperature({X, Y, Z}).duv;
    reading.colourTemperature = colourTemperatureOf(reading, reading.duv);
  }
  for (const SpectralChannel& channel : image.spectrum) {
    double sum = 0;
    for (const std::size_t i : pixels) sum += at(channel.values, i);
    reading.spectrum.emplace_back(channel.wavelength_nm, sum / n);
  }
  return reading;
}

std::size_t numberOf(const XyzImage& image, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column);
}

}  // namespace

PatchReading readPatch(const XyzImage& image, int column, int row, double radius) {
  assert(column >= 0 && column < image.width && row >= 0 && row < image.height && radius >= 0);
  std::vector<std::size_t> pixels;
  const auto reach = static_cast<int>(std::min(radius, 1e6));
  for (int y = std::max(0, row - reach); y <= std::min(image.height - 1, row + reach); ++y)
    for (int x = std::max(0, column - reach); x <= std::min(image.width - 1, column + reach); ++x)
      if (std::hypot(x - column, y - row) <= radius) pixels.push_back(numberOf(image, x, y));
  return readPixels(image, pixels);
}

PatchReading readPolygon(const XyzImage& image, const std::vector<core::Vec2>& corners) {
  std::vector<std::size_t> pixels;
  std::vector<double> crossings;
  for (int row = 0; row < image.height; ++row) {
    // Where the row's middle line crosses the edges: between the first and the second lies the inside, and so on.
    const double y = row + 0.5;
    crossings.clear();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const core::Vec2 &a = corners[k], &b = corners[(k + 1) % corners.size()];
      if ((a.y <= y) != (b.y <= y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
      for (int column = 0; column < image.width; ++column)
        if (column + 0.5 >= crossings[k] && column + 0.5 < crossings[k + 1])
          pixels.push_back(numberOf(image, column, row));
  }
  return readPixels(image, pixels);
}

}  // namespace goniolux::image
