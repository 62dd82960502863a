#include "display/display_image.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "display/adopted_white.h"
#include "display/code_tables.h"
#include "spectrum/colour_difference.h"

namespace goniolux::display {
namespace {

constexpr std::size_t pieceSize = 65536;
constexpr std::size_t mostMeasured = 500000;  // pixels whose colour difference is predicted
// What single precision leaves of a primary that should be 0, relative to the largest.
constexpr float rounding = 2e-6F;

glm::vec3 xyzOf(const spectrum::Chromaticity& colour) {
  return glm::vec3(colour.x / colour.y, 1, (1 - colour.x - colour.y) / colour.y);
}

// Everything that is the same for all pixels.
struct Work {
  const image::XyzImage& image;
  const ToneMap& tone;
  glm::mat3 adapt{1};
  std::unique_ptr<DeviceModel> model;
  CodeTables tables;
  glm::vec3 white{1};             // light of the device's white
  glm::vec3 luminance{1.0F / 3};  // of the primaries of a linear device
  double dark = 0;
  GamutMapping gamut;
  std::size_t stride = 1;  // every so many pixels one is measured
};

struct Count {
  std::size_t outOfGamut = 0, tooBright = 0, tooDark = 0, invalid = 0;
  std::vector<float> deltas;
};

std::uint8_t shortfallOf(const Work& work, const glm::vec3& light, const glm::vec3& value) {
  const float lowest = std::min({value.x, value.y, value.z}), highest = std::max({value.x, value.y, value.z});
  if (work.model->isLinear()) {
    std::uint8_t result = 0;
    if (highest > work.tables.brightest) result |= tooBright;
    if (lowest < work.tables.darkest - rounding * highest)
      result = static_cast<std::uint8_t>(result | (highest <= 0 ? tooDark : outOfGamut));
    return result;
  }
  if (lowest >= work.tables.darkest && highest <= work.tables.brightest) return 0;
  if (light.y > 1) return tooBright;
  return static_cast<double>(light.y) < work.dark ? tooDark : outOfGamut;
}

double deltaOf(const glm::vec3& wanted, const glm::vec3& shown, const glm::vec3& white) {
  const auto xyz = [](const glm::vec3& v) {
    return spectrum::Xyz{static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
  };
  return spectrum::deltaE2000(spectrum::lab(xyz(wanted), xyz(white)), spectrum::lab(xyz(shown), xyz(white)));
}

void displayPiece(const Work& work, std::size_t begin, std::size_t end, DisplayedImage& result, Count& count) {
  std::vector<glm::vec3> light(end - begin);
  for (std::size_t i = begin; i < end; ++i) {
    const glm::vec3 xyz(work.image.x[i], work.image.y[i], work.image.z[i]);
    if (!std::isfinite(xyz.x + xyz.y + xyz.z)) {
      result.shortfalls[i] = invalid;
      ++count.invalid;
      continue;  // black
    }
    light[i - begin] = work.adapt * (xyz * work.tone.curve->factor(xyz.y));
  }
  std::vector<glm::vec3> values = light;
  work.model->toDevice(values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::uint8_t& shortfall = result.shortfalls[begin + k];
    if (shortfall != invalid) shortfall = shortfallOf(work, light[k], values[k]);
    count.outOfGamut += (shortfall & outOfGamut) != 0;
    count.tooBright += (shortfall & tooBright) != 0;
    count.tooDark += (shortfall & tooDark) != 0;
    if (work.model->isLinear() && (shortfall != 0 || work.gamut == GamutMapping::compress))
      values[k] = intoGamut(values[k], work.luminance, work.gamut);
  }
  if (!work.model->isLinear()) searchIntoGamut(*work.model, light, values, work.white, work.dark, work.gamut);
  for (std::size_t k = 0; k < values.size(); ++k)
    for (int c = 0; c < 3; ++c)
      result.codes.rgb[3 * (begin + k) + static_cast<std::size_t>(c)] = work.tables.encode(c, values[k][c]);

  std::vector<std::size_t> measured;
  std::vector<glm::vec3> shown;
  for (std::size_t i = (begin + work.stride - 1) / work.stride * work.stride; i < end; i += work.stride) {
    if (result.shortfalls[i] == invalid) continue;
    measured.push_back(i);
    shown.push_back(work.tables.decoded(result.codes.rgb.data() + 3 * i));
  }
  work.model->toLight(shown);
  for (std::size_t k = 0; k < measured.size(); ++k)
    count.deltas.push_back(static_cast<float>(deltaOf(light[measured[k] - begin], shown[k], work.white)));
}

void summariseDeltas(std::vector<float>& deltas, DisplayedImage& result) {
  result.deltaPixels = deltas.size();
  if (deltas.empty()) return;
  double sum = 0;
  for (const float delta : deltas) sum += static_cast<double>(delta);
  result.deltaMean = sum / static_cast<double>(deltas.size());
  result.deltaMax = static_cast<double>(*std::max_element(deltas.begin(), deltas.end()));
  const auto p95 = static_cast<std::ptrdiff_t>(std::ceil(0.95 * static_cast<double>(deltas.size()))) - 1;
  std::nth_element(deltas.begin(), deltas.begin() + p95, deltas.end());
  result.deltaP95 = static_cast<double>(deltas[static_cast<std::size_t>(p95)]);
}

}  // namespace

DisplayedImage displayImage(const image::XyzImage& original, const Device& device, const DisplaySettings& settings) {
  assert(settings.bits == 8 || settings.bits == 10 || settings.bits == 16);
  DisplayedImage result;
  const auto from = settings.adoptedWhite;
  core::Mat3 adapt = from ? adaptation(*from, device.white, settings.adaptation) : core::Mat3(1);
  // For the statistics an ICC profile counts as X, Y, Z.
  const core::Mat3 toValues = device.kind == Device::Kind::icc ? core::Mat3(1) : rgbFromXyz(device, std::nullopt);
  result.statistics = luminanceStatistics(original, toValues * adapt);
  const ToneMap tone = settings.mapping.type->make({original, result.statistics, device.white_cd_m2, darkest(device)},
                                                   settings.mapping.arguments);
  result.method = tone.method;
  result.white_cd_m2 = tone.white_cd_m2;
  if (tone.coloursAreFixed) adapt = adaptation(daylight, device.white, settings.adaptation);
  const image::XyzImage& image = tone.seen ? *tone.seen : original;

  Work work{image,
            tone,
            glm::mat3(adapt),
            makeModel(device),
            CodeTables(device, settings.bits),
            xyzOf(device.white),
            glm::vec3(1.0F / 3),
            darkest(device),
            settings.gamut,
            1};
  if (work.model->isLinear()) {
    const core::Mat3 matrix = xyzFromRgb(device);
    work.luminance = {matrix[0].y, matrix[1].y, matrix[2].y};
  }
  work.stride = (image.y.size() + mostMeasured - 1) / mostMeasured;

  result.codes.width = image.width;
  result.codes.height = image.height;
  result.codes.bits = settings.bits;
  result.codes.rgb.resize(3 * image.y.size());
  result.shortfalls.assign(image.y.size(), 0);
  // Counts are kept per piece and added in order: no thread waits for another.
  std::vector<Count> counts((image.y.size() + pieceSize - 1) / pieceSize);
  core::parallelFor(counts.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t piece = first; piece < last; ++piece)
      displayPiece(work, piece * pieceSize, std::min(image.y.size(), (piece + 1) * pieceSize), result, counts[piece]);
  });
  std::vector<float> deltas;
  for (const Count& count : counts) {
    result.outOfGamut += count.outOfGamut;
    result.tooBright += count.tooBright;
    result.tooDark += count.tooDark;
    result.invalid += count.invalid;
    deltas.insert(deltas.end(), count.deltas.begin(), count.deltas.end());
  }
  summariseDeltas(deltas, result);
  return result;
}

CodeImage shortfallMap(const DisplayedImage& displayed) {
  CodeImage map;
  map.width = displayed.codes.width;
  map.height = displayed.codes.height;
  map.bits = 8;
  map.rgb.resize(displayed.codes.rgb.size());
  const int shift = displayed.codes.bits - 8;
  for (std::size_t i = 0; i < displayed.shortfalls.size(); ++i) {
    const std::uint16_t* code = displayed.codes.rgb.data() + 3 * i;
    const int grey = 40 + ((code[0] + 2 * code[1] + code[2]) >> shift) * 5 / 32;  // dimmed: colours stand out
    const std::uint8_t shortfall = displayed.shortfalls[i];
    glm::ivec3 colour(grey);
    if (shortfall == outOfGamut) colour = {230, 40, 200};
    if (shortfall == tooBright) colour = {245, 215, 30};
    if ((shortfall & tooDark) != 0) colour = {20, 160, 190};
    if (shortfall == (outOfGamut | tooBright)) colour = {225, 40, 20};
    if (shortfall == invalid) colour = {255, 255, 255};
    for (int c = 0; c < 3; ++c) map.rgb[3 * i + static_cast<std::size_t>(c)] = static_cast<std::uint16_t>(colour[c]);
  }
  return map;
}

}  // namespace goniolux::display
