#include "display/inverse.h"

#include <fmt/format.h>

#include <cmath>

#include "core/diagnostics.h"
#include "core/parallel.h"
#include "core/text.h"
#include "display/device_model.h"
#include "spectrum/colour_difference.h"

namespace goniolux::display {

image::XyzImage lightOf(const CodeImage& codes, const Device& device) {
  const auto model = makeModel(device);
  const float scale = device.white_cd_m2 > 0 ? static_cast<float>(device.white_cd_m2) : 1;
  const double largest = (1 << codes.bits) - 1;
  const std::size_t count = codes.rgb.size() / 3;
  image::XyzImage image;
  image.width = codes.width;
  image.height = codes.height;
  image.x.resize(count), image.y.resize(count), image.z.resize(count);
  std::array<std::vector<float>, 3> decoded;
  for (int c = 0; c < 3; ++c)
    for (int code = 0; code <= static_cast<int>(largest); ++code)
      decoded[static_cast<std::size_t>(c)].push_back(static_cast<float>(model->decode(c, code / largest)));
  core::parallelFor(count, 1 << 14, [&](std::size_t begin, std::size_t end) {
    std::vector<glm::vec3> pixels;
    for (std::size_t i = begin; i < end; ++i)
      pixels.emplace_back(decoded[0][codes.rgb[3 * i]], decoded[1][codes.rgb[3 * i + 1]],
                          decoded[2][codes.rgb[3 * i + 2]]);
    model->toLight(pixels);
    for (std::size_t i = begin; i < end; ++i) {
      const glm::vec3 light = pixels[i - begin] * scale;
      image.x[i] = light.x;
      image.y[i] = light.y;
      image.z[i] = light.z;
    }
  });
  image.attributes[image::unitsAttribute] = device.white_cd_m2 > 0 ? "cd/m2" : "relative";
  image.attributes[image::adoptedWhiteAttribute] = fmt::format("{:.5f} {:.5f}", device.white.x, device.white.y);
  image.attributes["device"] = device.name;
  return image;
}

std::vector<Patch> readPatches(const std::string& text, const std::string& path, int bits) {
  core::Diagnostics diagnostics;
  std::vector<Patch> patches;
  core::TextScanner lines(text);
  const double largest = (1 << bits) - 1;
  while (const auto line = lines.line()) {
    core::TextScanner words(line->text.substr(0, line->text.find('#')));
    std::vector<double> numbers;
    bool fits = true;
    while (const auto word = words.word(",;")) {
      const auto value = core::parseNumber(word->text);
      const bool isCode = numbers.size() < 3;
      if (value && std::isfinite(*value) && (!isCode || (*value >= 0 && *value <= largest))) {
        numbers.push_back(*value);
        continue;
      }
      fits = false;
      diagnostics.error(
          {path, line->line, word->column}, "patch",
          isCode ? fmt::format("'{}' is no code value; with {} bits they run from 0 to {}", word->text, bits, largest)
                 : fmt::format("'{}' is no number", word->text));
    }
    if (!fits || numbers.empty()) continue;
    if (numbers.size() != 3 && numbers.size() != 6) {
      diagnostics.error({path, line->line, 1}, "patch", "a line holds R G B, or R G B and the measured X Y Z");
      continue;
    }
    Patch patch;
    patch.codes = {numbers[0], numbers[1], numbers[2]};
    if (numbers.size() == 6) patch.measured = core::Vec3(numbers[3], numbers[4], numbers[5]);
    patches.push_back(patch);
  }
  if (patches.empty() && !diagnostics.hasErrors())
    diagnostics.error({path, 0, 0}, "patch", "the file holds no patches; give lines of R G B, or R G B X Y Z");
  if (diagnostics.hasErrors()) throw core::InputError(std::move(diagnostics));
  return patches;
}

void predict(std::vector<Patch>& patches, const Device& device, int bits) {
  const auto model = makeModel(device);
  const double scale = device.white_cd_m2 > 0 ? device.white_cd_m2 : 1, largest = (1 << bits) - 1;
  const auto xyz = [](const core::Vec3& v) { return spectrum::Xyz{v.x, v.y, v.z}; };
  const spectrum::Chromaticity& w = device.white;
  const core::Vec3 white = core::Vec3(w.x / w.y, 1, (1 - w.x - w.y) / w.y) * scale;
  for (Patch& patch : patches) {
    std::vector<glm::vec3> light(1);
    for (int c = 0; c < 3; ++c)
      light[0][c] = static_cast<float>(model->decode(c, patch.codes[static_cast<std::size_t>(c)] / largest));
    model->toLight(light);
    patch.predicted = core::Vec3(light[0]) * scale;
    if (patch.measured)
      patch.delta = spectrum::deltaE2000(spectrum::lab(xyz(patch.predicted), xyz(white)),
                                         spectrum::lab(xyz(*patch.measured), xyz(white)));
  }
}

}  // namespace goniolux::display
