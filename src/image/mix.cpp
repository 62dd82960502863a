#include "image/mix.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "core/text.h"

namespace goniolux::image {
namespace {

std::vector<double> numbersOf(const XyzImage& image, const char* attribute) {
  std::vector<double> numbers;
  const auto found = image.attributes.find(attribute);
  if (found == image.attributes.end()) return numbers;
  core::TextScanner scanner(found->second);
  while (const auto word = scanner.word(","))
    if (const auto value = core::parseNumber(word->text)) numbers.push_back(*value);
  return numbers;
}

bool all(const std::vector<MixPart>& parts, bool (*has)(const XyzImage&)) {
  return std::all_of(parts.begin(), parts.end(), [&](const MixPart& part) { return has(*part.image); });
}

void mixAttributes(const std::vector<MixPart>& parts, XyzImage& sum) {
  sum.attributes = parts.front().image->attributes;
  for (const MixPart& part : parts)
    std::erase_if(sum.attributes, [&](const auto& each) {
      const auto found = part.image->attributes.find(each.first);
      return found == part.image->attributes.end() || found->second != each.second;
    });
  std::array<double, 3> flux{};
  for (const MixPart& part : parts) {
    const std::vector<double> numbers = numbersOf(*part.image, sourceFluxAttribute);
    if (numbers.size() != 3) return;
    for (std::size_t c = 0; c < 3; ++c) flux[c] += part.level * numbers[c];
  }
  sum.attributes[sourceFluxAttribute] = fmt::format("{:.8g} {:.8g} {:.8g}", flux[0], flux[1], flux[2]);
  const double total = flux[0] + flux[1] + flux[2];
  if (total > 0) sum.attributes[adoptedWhiteAttribute] = fmt::format("{:.5f} {:.5f}", flux[0] / total, flux[1] / total);
}

void mixHalfWidths(const std::vector<MixPart>& parts, XyzImage& sum) {
  const std::size_t count = sum.y.size();
  std::vector<double> systematic;  // relative to Y, of each part
  for (const MixPart& part : parts) {
    const std::vector<double> numbers = numbersOf(*part.image, systematicAttribute);
    systematic.push_back(numbers.size() == 1 ? numbers[0] : -1);
  }
  const bool known = std::none_of(systematic.begin(), systematic.end(), [](double s) { return s < 0; });
  const bool chromatic =
      all(parts, [](const XyzImage& i) { return !i.chromaticityX.empty() && !i.chromaticityY.empty(); });
  sum.halfWidth.resize(count);
  if (chromatic) sum.chromaticityX.resize(count), sum.chromaticityY.resize(count);
  double shares = 0, luminance = 0;  // of the systematic parts in the whole image
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = [i](const std::vector<float>& values) { return static_cast<double>(values[i]); };
    const double S = at(sum.x) + at(sum.y) + at(sum.z);
    const double x = S > 0 ? at(sum.x) / S : 0, y = S > 0 ? at(sum.y) / S : 0;
    double squares = 0, common = 0, squaresX = 0, squaresY = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const XyzImage& image = *parts[k].image;
      const double level = parts[k].level, whole = level * at(image.halfWidth);
      const double shared = known ? std::min(whole, systematic[k] * level * std::abs(at(image.y))) : 0;
      squares += (whole - shared) * (whole - shared);
      common += shared;
      if (!chromatic) continue;
      // As in a patch (patch.cpp): dx = sum (S_k dx_k + (x_k - x) dS_k) / S.
      const double Sk = level * (at(image.x) + at(image.y) + at(image.z));
      if (!(Sk > 0)) continue;
      const double relative = image.y[i] > 0 ? at(image.halfWidth) / at(image.y) : 0;
      const double dx = Sk * at(image.chromaticityX) + std::abs(level * at(image.x) - x * Sk) * relative;
      const double dy = Sk * at(image.chromaticityY) + std::abs(level * at(image.y) - y * Sk) * relative;
      squaresX += dx * dx;
      squaresY += dy * dy;
    }
    sum.halfWidth[i] = static_cast<float>(std::sqrt(squares) + common);
    shares += common;
    luminance += std::abs(at(sum.y));
    if (chromatic && S > 0) {
      sum.chromaticityX[i] = static_cast<float>(std::sqrt(squaresX) / S);
      sum.chromaticityY[i] = static_cast<float>(std::sqrt(squaresY) / S);
    }
  }
  if (known) sum.attributes[systematicAttribute] = fmt::format("{:.6g}", luminance > 0 ? shares / luminance : 0);
}

// Half-widths of independent images: in squares, where all have them.
template <class Plane>
void addSquares(const std::vector<MixPart>& parts, std::vector<float>& into, const Plane& plane) {
  const bool known =
      std::none_of(parts.begin(), parts.end(), [&](const MixPart& part) { return plane(*part.image).empty(); });
  if (!known) return;
  into.assign(parts.front().image->y.size(), 0);
  for (const MixPart& part : parts) {
    const auto level = static_cast<float>(part.level);
    if (level == 0) continue;
    const std::vector<float>& values = plane(*part.image);
    for (std::size_t i = 0; i < into.size(); ++i) into[i] = std::hypot(into[i], level * values[i]);
  }
}

}  // namespace

std::optional<XyzImage> layerOf(const XyzImage& image, const std::string& name) {
  const auto found =
      std::find_if(image.layers.begin(), image.layers.end(), [&](const Layer& each) { return each.name == name; });
  if (found == image.layers.end()) return std::nullopt;
  XyzImage layer;
  layer.width = image.width;
  layer.height = image.height;
  layer.x = found->x, layer.y = found->y, layer.z = found->z;
  layer.halfWidth = found->halfWidth;
  layer.attributes = image.attributes;
  layer.attributes["layer"] = name;
  return layer;
}

XyzImage mixed(const std::vector<MixPart>& parts) {
  assert(!parts.empty());
  XyzImage sum;
  sum.width = parts.front().image->width;
  sum.height = parts.front().image->height;
  const std::size_t count = parts.front().image->y.size();
  const auto add = [&](std::vector<float>& into, auto plane) {
    into.assign(count, 0);
    core::parallelFor(count, 1 << 15, [&](std::size_t begin, std::size_t end) {
      for (const MixPart& part : parts) {
        const std::vector<float>& values = plane(*part.image);
        const auto level = static_cast<float>(part.level);
        if (level == 0) continue;  // also where the value is no number
        for (std::size_t i = begin; i < end; ++i) into[i] += level * values[i];
      }
    });
  };
  add(sum.x, [](const XyzImage& i) -> const std::vector<float>& { return i.x; });
  add(sum.y, [](const XyzImage& i) -> const std::vector<float>& { return i.y; });
  add(sum.z, [](const XyzImage& i) -> const std::vector<float>& { return i.z; });
  const auto& first = parts.front().image->spectrum;
  for (std::size_t k = 0; k < first.size(); ++k) {
    const bool shared = std::all_of(parts.begin(), parts.end(), [&](const MixPart& part) {
      return k < part.image->spectrum.size() && part.image->spectrum[k].wavelength_nm == first[k].wavelength_nm;
    });
    if (!shared) break;
    sum.spectrum.push_back({first[k].wavelength_nm, {}, {}});
    add(sum.spectrum.back().values,
        [k](const XyzImage& i) -> const std::vector<float>& { return i.spectrum[k].values; });
    addSquares(parts, sum.spectrum.back().halfWidth,
               [k](const XyzImage& i) -> const std::vector<float>& { return i.spectrum[k].halfWidth; });
  }
  for (std::size_t k = 0; k < parts.front().image->layers.size(); ++k) {
    const std::string& name = parts.front().image->layers[k].name;
    const bool shared = std::all_of(parts.begin(), parts.end(), [&](const MixPart& part) {
      return k < part.image->layers.size() && part.image->layers[k].name == name;
    });
    if (!shared) break;
    Layer& layer = sum.layers.emplace_back();
    layer.name = name;
    add(layer.x, [k](const XyzImage& i) -> const std::vector<float>& { return i.layers[k].x; });
    add(layer.y, [k](const XyzImage& i) -> const std::vector<float>& { return i.layers[k].y; });
    add(layer.z, [k](const XyzImage& i) -> const std::vector<float>& { return i.layers[k].z; });
    addSquares(parts, layer.halfWidth,
               [k](const XyzImage& i) -> const std::vector<float>& { return i.layers[k].halfWidth; });
  }
  mixAttributes(parts, sum);
  if (all(parts, [](const XyzImage& i) { return !i.halfWidth.empty(); })) mixHalfWidths(parts, sum);
  return sum;
}

}  // namespace goniolux::image
