#include "analysis/image_glare.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "analysis/position_index.h"
#include "analysis/ugr_table.h"
#include "core/parallel.h"

namespace goniolux::analysis {
namespace {

using core::Vec3;

// Solid angle of a spherical triangle of unit vectors — Van Oosterom and Strackee, IEEE TBME 30(2), 1983.
double triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double volume = std::abs(glm::dot(a, glm::cross(b, c)));
  return 2 * std::atan2(volume, 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

struct Frame {
  Vec3 forward, up;
};
Frame frameOf(const scene::View& view) {
  const Vec3 forward = glm::normalize(view.target - view.eye);
  return {forward, glm::normalize(view.up - forward * glm::dot(view.up, forward))};
}

}  // namespace

double solidAngleOf(const scene::View& view, int column, int row) {
  if (!scene::rayThrough(view, column + 0.5, row + 0.5).inside) return 0;
  const auto at = [&](int x, int y) { return scene::rayThrough(view, column + x, row + y).direction; };
  const Vec3 a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
  // A pixel on the rim of the circle has corners outside it, whose rays are not made: its middle stands for them.
  for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
    if (!scene::rayThrough(view, column + x, row + y).inside) {
      const auto mid = [&](double u, double v) { return scene::rayThrough(view, column + u, row + v).direction; };
      const Vec3 across = mid(0.501, 0.5) - mid(0.499, 0.5), down = mid(0.5, 0.501) - mid(0.5, 0.499);
      return glm::length(glm::cross(across, down)) / (0.002 * 0.002);
    }
  return triangle(a, b, c) + triangle(a, c, d);
}

double positionIndexAround(const Vec3& forward, const Vec3& up, const Vec3& toSource) {
  if (glm::dot(toSource, up) >= 0) return positionIndex(forward, up, toSource);
  const double depth = glm::dot(toSource, forward);
  if (!(depth > 0)) return 16;  // behind: as far off as the index goes
  const double ratio = glm::length(toSource - forward * depth) / depth;
  return 1 + (ratio < 0.6 ? 0.8 : 1.2) * ratio;
}

ImageGlare glareOf(const image::XyzImage& image, const scene::View& view, double threshold_cd_m2) {
  assert(view.projection != scene::View::Projection::orthographic);
  const auto width = static_cast<std::size_t>(image.width), count = image.y.size();
  const Frame frame = frameOf(view);
  std::vector<float> solidAngle(count);
  core::parallelFor(static_cast<std::size_t>(image.height), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (int x = 0; x < image.width; ++x)
        solidAngle[y * width + static_cast<std::size_t>(x)] =
            static_cast<float>(solidAngleOf(view, x, static_cast<int>(y)));
  });
  ImageGlare result;
  result.threshold_cd_m2 = threshold_cd_m2;
  const auto directionOf = [&](std::size_t i) {
    return scene::rayThrough(view, static_cast<double>(i % width) + 0.5, static_cast<double>(i / width) + 0.5)
        .direction;
  };
  std::vector<char> bright(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (!(solidAngle[i] > 0) || !std::isfinite(image.y[i])) continue;
    const double omega = static_cast<double>(solidAngle[i]), luminance = static_cast<double>(image.y[i]);
    result.solidAngle_sr += omega;
    result.verticalIlluminance_lx += luminance * omega * std::max(0.0, glm::dot(directionOf(i), frame.forward));
    bright[i] = luminance > threshold_cd_m2;
  }

  double fromSources = 0;
  std::vector<std::size_t> open;
  for (std::size_t start = 0; start < count; ++start) {
    if (bright[start] == 0) continue;
    ImageSource source;
    double light = 0, column = 0, row = 0;
    Vec3 middle(0);
    bright[start] = 0;
    open.assign(1, start);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      const double omega = static_cast<double>(solidAngle[i]), part = static_cast<double>(image.y[i]) * omega;
      const Vec3 direction = directionOf(i);
      source.solidAngle_sr += omega;
      ++source.pixels;
      light += part;
      middle += direction * part;
      column += part * static_cast<double>(i % width);
      row += part * static_cast<double>(i / width);
      fromSources += part * std::max(0.0, glm::dot(direction, frame.forward));
      const auto x = static_cast<int>(i % width), y = static_cast<int>(i / width);
      for (int v = std::max(0, y - 1); v <= std::min(image.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(image.width - 1, x + 1); ++u) {
          const std::size_t neighbour = static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
          if (bright[neighbour] == 0) continue;
          bright[neighbour] = 0;
          open.push_back(neighbour);
        }
    }
    source.luminance_cd_m2 = light / source.solidAngle_sr;
    source.direction = glm::normalize(middle);
    source.column = static_cast<int>(std::lround(column / light));
    source.row = static_cast<int>(std::lround(row / light));
    source.positionIndex = positionIndexAround(frame.forward, frame.up, source.direction);
    result.sources.push_back(source);
  }
  const auto weight = [](const ImageSource& s) {
    return s.luminance_cd_m2 * s.luminance_cd_m2 * s.solidAngle_sr / (s.positionIndex * s.positionIndex);
  };
  std::stable_sort(result.sources.begin(), result.sources.end(),
                   [&](const ImageSource& a, const ImageSource& b) { return weight(a) > weight(b); });
  double sum = 0;
  for (const ImageSource& source : result.sources) sum += weight(source);
  const double Ev = result.verticalIlluminance_lx;
  result.background_cd_m2 = std::max(0.0, Ev - fromSources) / core::pi;
  if (sum > 0 && result.background_cd_m2 > 0) result.ugr = std::max(0.0, ugr(sum, result.background_cd_m2));
  result.dgp = 5.87e-5 * Ev + 0.0918 * std::log10(1 + (Ev > 0 ? sum / std::pow(Ev, 1.87) : 0)) + 0.16;
  return result;
}

}  // namespace goniolux::analysis
