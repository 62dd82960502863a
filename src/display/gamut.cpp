#include "display/gamut.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/closest_name.h"
#include "core/diagnostics.h"

namespace goniolux::display {
namespace {

constexpr float knee = 0.8F;  // of the way from grey to the boundary, where `compress` begins

bool isInside(const glm::vec3& v) {  // false for NaN
  constexpr float slack = 1e-5F;
  return std::min({v.x, v.y, v.z}) >= -slack && std::max({v.x, v.y, v.z}) <= 1 + slack;
}

// How far along grey + t * way the boundary of the cube lies.
float boundary(float grey, const glm::vec3& way) {
  float t = std::numeric_limits<float>::infinity();
  for (int c = 0; c < 3; ++c) {
    if (way[c] > 0) t = std::min(t, (1 - grey) / way[c]);
    if (way[c] < 0) t = std::min(t, -grey / way[c]);
  }
  return t;
}

}  // namespace

std::vector<std::string> gamutMappingNames() {
  return {"clip", "neutral", "compress"};
}

GamutMapping gamutMappingNamed(const std::string& name) {
  const auto names = gamutMappingNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw core::InputError({}, "gamut",
                           fmt::format("there is no gamut mapping '{}'{}", name, core::suggestion(name, names)));
  return static_cast<GamutMapping>(found - names.begin());
}

glm::vec3 intoGamut(const glm::vec3& value, const glm::vec3& luminance, GamutMapping mapping) {
  if (mapping == GamutMapping::clip) return glm::clamp(value, 0.0F, 1.0F);
  const float grey = std::clamp(glm::dot(value, luminance), 0.0F, 1.0F);
  if (grey <= 0 || grey >= 1) return glm::vec3(grey);
  const glm::vec3 way = value - glm::dot(value, luminance);
  const float t = boundary(grey, way);
  if (mapping == GamutMapping::neutral) return glm::clamp(grey + way * std::min(1.0F, t), 0.0F, 1.0F);
  const float place = 1 / t;  // 1: on the boundary
  if (place <= knee) return grey + way;
  const float compressed = knee + (1 - knee) * (1 - std::exp(-(place - knee) / (1 - knee)));
  return glm::clamp(grey + way * (compressed / place), 0.0F, 1.0F);
}

void searchIntoGamut(const DeviceModel& model, std::span<const glm::vec3> light, std::span<glm::vec3> values,
                     const glm::vec3& white, double darkest, GamutMapping mapping) {
  std::vector<std::size_t> outside;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (isInside(values[i])) continue;
    const bool hasNumbers = std::isfinite(values[i].x + values[i].y + values[i].z);
    if (mapping == GamutMapping::clip && hasNumbers)
      values[i] = glm::clamp(values[i], 0.0F, 1.0F);
    else
      outside.push_back(i);
  }
  if (outside.empty()) return;
  // Bisection of the way from grey (0) to the colour (1), all of them together.
  std::vector<float> low(outside.size(), 0), high(outside.size(), 1);
  std::vector<glm::vec3> trial(outside.size()), best(outside.size(), glm::vec3(std::nanf("")));
  for (int round = 0; round < 12; ++round) {
    for (std::size_t k = 0; k < outside.size(); ++k) {
      const glm::vec3& wanted = light[outside[k]];
      const float t = round == 0 ? 0 : 0.5F * (low[k] + high[k]);
      const glm::vec3 grey = white * std::clamp(wanted.y, static_cast<float>(darkest), 1.0F);
      trial[k] = grey + (wanted - white * wanted.y) * t;
    }
    model.toDevice(trial);
    for (std::size_t k = 0; k < outside.size(); ++k) {
      const float t = round == 0 ? 0 : 0.5F * (low[k] + high[k]);
      if (isInside(trial[k]) || round == 0) {
        low[k] = t;
        best[k] = trial[k];
      } else {
        high[k] = t;
      }
    }
  }
  for (std::size_t k = 0; k < outside.size(); ++k) {
    const glm::vec3& found = best[k];
    const bool hasNumbers = std::isfinite(found.x + found.y + found.z);
    values[outside[k]] =
        hasNumbers ? glm::clamp(found, 0.0F, 1.0F) : glm::vec3(light[outside[k]].y > 0.5F ? 1.0F : 0.0F);
  }
}

}  // namespace goniolux::display
