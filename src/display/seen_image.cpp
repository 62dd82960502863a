#include "display/seen_image.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "core/text.h"
#include "core/vector.h"
#include "display/visual_threshold.h"

namespace goniolux::display {
namespace {

using image::XyzImage;

// Bilinear reading of a foveal plane at a pixel of the image.
struct Place {
  std::array<std::size_t, 4> index;
  std::array<double, 4> weight;
};
Place placeIn(const FovealImage& foveal, const XyzImage& image, int x, int y) {
  const double u = std::clamp((x + 0.5) * foveal.width / image.width - 0.5, 0.0, foveal.width - 1.0);
  const double v = std::clamp((y + 0.5) * foveal.height / image.height - 0.5, 0.0, foveal.height - 1.0);
  const auto x0 = static_cast<int>(u), y0 = static_cast<int>(v);
  const int x1 = std::min(x0 + 1, foveal.width - 1), y1 = std::min(y0 + 1, foveal.height - 1);
  const double fx = u - x0, fy = v - y0;
  const auto at = [&](int a, int b) {
    return static_cast<std::size_t>(b) * static_cast<std::size_t>(foveal.width) + static_cast<std::size_t>(a);
  };
  return {{at(x0, y0), at(x1, y0), at(x0, y1), at(x1, y1)},
          {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}};
}
double read(const std::vector<double>& plane, const Place& place) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += place.weight[i] * plane[place.index[i]];
  return sum;
}

template <typename Body>
void forAllRows(const XyzImage& image, const Body& body) {
  core::parallelFor(static_cast<std::size_t>(image.height), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (int x = 0; x < image.width; ++x)
        body(y * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x), x, static_cast<int>(y));
  });
}

struct Level {
  int width = 0, height = 0;
  std::vector<glm::vec3> pixels;
};

Level halved(const Level& finer) {
  Level level{(finer.width + 1) / 2, (finer.height + 1) / 2, {}};
  level.pixels.resize(static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height));
  for (int y = 0; y < level.height; ++y)
    for (int x = 0; x < level.width; ++x) {
      glm::vec3 sum(0);
      for (const int dy : {0, 1})
        for (const int dx : {0, 1}) {
          const int u = std::min(2 * x + dx, finer.width - 1), v = std::min(2 * y + dy, finer.height - 1);
          sum += finer.pixels[static_cast<std::size_t>(v) * static_cast<std::size_t>(finer.width) +
                              static_cast<std::size_t>(u)];
        }
      level.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x)] =
          sum / 4.0F;
    }
  return level;
}

glm::vec3 read(const Level& level, double u, double v) {
  u = std::clamp(u * level.width - 0.5, 0.0, level.width - 1.0);
  v = std::clamp(v * level.height - 0.5, 0.0, level.height - 1.0);
  const int x = static_cast<int>(u), y = static_cast<int>(v);
  const int x1 = std::min(x + 1, level.width - 1), y1 = std::min(y + 1, level.height - 1);
  const auto fx = static_cast<float>(u - x), fy = static_cast<float>(v - y);
  const auto at = [&](int a, int b) {
    return level
        .pixels[static_cast<std::size_t>(b) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(a)];
  };
  return (at(x, y) * (1 - fx) + at(x1, y) * fx) * (1 - fy) + (at(x, y1) * (1 - fx) + at(x1, y1) * fx) * fy;
}

}  // namespace

double degreesAcross(const XyzImage& image) {
  auto view = image.attributes.find(image::viewGeometryAttribute);
  if (view == image.attributes.end()) view = image.attributes.find(image::viewAttribute);
  if (view != image.attributes.end()) {
    core::TextScanner scanner(view->second);
    while (const auto word = scanner.word("")) {
      if (word->text != "-vh") continue;
      const auto value = scanner.word("");
      const auto degrees = value ? core::parseNumber(value->text) : std::nullopt;
      if (degrees && *degrees > 0 && *degrees <= 360) return *degrees;
    }
  }
  return 60;
}

FovealImage fovealImage(const XyzImage& image, double degrees) {
  FovealImage foveal;
  foveal.width = std::clamp(static_cast<int>(std::lround(degrees)), 1, image.width);
  foveal.height = std::clamp(static_cast<int>(std::lround(degrees * image.height / image.width)), 1, image.height);
  foveal.degreesPerPixel = degrees / foveal.width;
  const auto count = static_cast<std::size_t>(foveal.width) * static_cast<std::size_t>(foveal.height);
  foveal.x.resize(count), foveal.y.resize(count), foveal.z.resize(count);
  core::parallelFor(count, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto u = static_cast<std::int64_t>(i) % foveal.width, v = static_cast<std::int64_t>(i) / foveal.width;
      const std::int64_t x0 = u * image.width / foveal.width,
                         x1 = std::max(x0 + 1, (u + 1) * image.width / foveal.width);
      const std::int64_t y0 = v * image.height / foveal.height,
                         y1 = std::max(y0 + 1, (v + 1) * image.height / foveal.height);
      double n = 0;
      for (std::int64_t y = y0; y < y1; ++y)
        for (std::int64_t x = x0; x < x1; ++x) {
          const auto at = static_cast<std::size_t>(y * image.width + x);
          if (!std::isfinite(image.x[at] + image.y[at] + image.z[at])) continue;
          foveal.x[i] += static_cast<double>(image.x[at]);
          foveal.y[i] += static_cast<double>(image.y[at]);
          foveal.z[i] += static_cast<double>(image.z[at]);
          ++n;
        }
      for (auto* plane : {&foveal.x, &foveal.y, &foveal.z}) (*plane)[i] /= std::max(n, 1.0);
    }
  });
  return foveal;
}

void addVeil(XyzImage& image, FovealImage& foveal) {
  const auto count = foveal.y.size();
  std::array<std::vector<double>, 3> veil;
  for (auto& plane : veil) plane.resize(count);
  // sum of cos / theta^2 over the other fixations divides: a uniform field of L is veiled by 0.087 L.
  core::parallelFor(count, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto width = static_cast<std::size_t>(foveal.width);
      const double u = static_cast<double>(i % width), v = static_cast<double>(i / width);
      double weights = 0;
      std::array<double, 3> sum{};
      for (std::size_t j = 0; j < count; ++j) {
        if (j == i) continue;
        const double theta = std::hypot(static_cast<double>(j % width) - u, static_cast<double>(j / width) - v) *
                             foveal.degreesPerPixel * core::degree;
        const double weight = std::max(0.0, std::cos(theta)) / (theta * theta);
        weights += weight;
        sum[0] += weight * foveal.x[j];
        sum[1] += weight * foveal.y[j];
        sum[2] += weight * foveal.z[j];
      }
      for (std::size_t c = 0; c < 3; ++c) veil[c][i] = weights > 0 ? 0.087 * sum[c] / weights : 0;
    }
  });
  forAllRows(image, [&](std::size_t i, int x, int y) {
    const Place place = placeIn(foveal, image, x, y);
    image.x[i] = 0.913F * image.x[i] + static_cast<float>(read(veil[0], place));
    image.y[i] = 0.913F * image.y[i] + static_cast<float>(read(veil[1], place));
    image.z[i] = 0.913F * image.z[i] + static_cast<float>(read(veil[2], place));
  });
  for (std::size_t i = 0; i < count; ++i) {
    foveal.x[i] = 0.913 * foveal.x[i] + veil[0][i];
    foveal.y[i] = 0.913 * foveal.y[i] + veil[1][i];
    foveal.z[i] = 0.913 * foveal.z[i] + veil[2][i];
  }
}

void fadeColours(XyzImage& image, const FovealImage& foveal) {
  forAllRows(image, [&](std::size_t i, int x, int y) {
    const double adaptation = read(foveal.y, placeIn(foveal, image, x, y));
    if (!(adaptation < 5.6) || !(image.x[i] > 0)) return;
    const double colour = std::clamp((adaptation - 0.0056) / (5.6 - 0.0056), 0.0, 1.0);
    const auto X = static_cast<double>(image.x[i]), Y = static_cast<double>(image.y[i]),
               Z = static_cast<double>(image.z[i]);
    const double scotopic = std::max(0.0, Y * (1.33 * (1 + (Y + Z) / X) - 1.68));
    image.x[i] = static_cast<float>(colour * X + (1 - colour) * scotopic);
    image.y[i] = static_cast<float>(colour * Y + (1 - colour) * scotopic);
    image.z[i] = static_cast<float>(colour * Z + (1 - colour) * scotopic);
  });
}

void blurToAcuity(XyzImage& image, const FovealImage& foveal) {
  const double pixelsPerDegree = image.width / (foveal.width * foveal.degreesPerPixel);
  std::vector<Level> levels{{image.width, image.height, {}}};
  levels[0].pixels.reserve(image.y.size());
  for (std::size_t i = 0; i < image.y.size(); ++i) levels[0].pixels.emplace_back(image.x[i], image.y[i], image.z[i]);
  while (levels.size() < 12 && std::min(levels.back().width, levels.back().height) > 1)
    levels.push_back(halved(levels.back()));
  forAllRows(image, [&](std::size_t i, int x, int y) {
    const double adaptation = std::max(1e-5, read(foveal.y, placeIn(foveal, image, x, y)));
    // Two pixels of level l resolve pixelsPerDegree / 2^(l+1) cycles per degree.
    const double level = std::log2(pixelsPerDegree / (2 * std::max(0.5, acuity(adaptation))));
    if (!(level > 0)) return;
    const auto low = std::min(static_cast<std::size_t>(level), levels.size() - 1);
    const std::size_t high = std::min(low + 1, levels.size() - 1);
    const double u = (x + 0.5) / image.width, v = (y + 0.5) / image.height;
    const auto share = static_cast<float>(std::min(1.0, level - static_cast<double>(low)));
    const glm::vec3 seen = read(levels[low], u, v) * (1 - share) + read(levels[high], u, v) * share;
    image.x[i] = seen.x;
    image.y[i] = seen.y;
    image.z[i] = seen.z;
  });
}

}  // namespace goniolux::display
