#include "scene/view_text.h"

#include <fmt/format.h>

#include <cmath>

#include "core/text.h"

namespace goniolux::scene {
namespace {

using core::Vec3;
using Projection = View::Projection;

std::string three(const char* key, const Vec3& v) {
  return fmt::format(" {} {:.9g} {:.9g} {:.9g}", key, v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

// Horizontal extent for a vertical one: angle in degrees, or length.
double horizontal(const View& view) {
  const double aspect = static_cast<double>(view.width) / view.height, half = 0.5 * view.verticalFov;
  switch (view.projection) {
    case Projection::orthographic:
      return view.span * aspect;
    case Projection::fisheyeEquidistant:
      return view.verticalFov * aspect / core::degree;
    case Projection::fisheyeEquisolid:
      return 4 * std::asin(std::min(1.0, std::sin(0.5 * half) * aspect)) / core::degree;
    default:
      return 2 * std::atan(std::tan(half) * aspect) / core::degree;
  }
}

}  // namespace

bool isKnownToRadiance(const View& view) {
  return view.projection != Projection::fisheyeEquisolid;
}

std::string viewText(const View& view) {
  const char* types[] = {"-vtv", "-vtl", "-vta", "-vte"};
  const bool flat = view.projection == Projection::orthographic;
  return types[static_cast<int>(view.projection)] + three("-vp", view.eye) +
         three("-vd", glm::normalize(view.target - view.eye)) + three("-vu", view.up) +
         fmt::format(" -vh {:.9g} -vv {:.9g}", horizontal(view), flat ? view.span : view.verticalFov / core::degree);
}

std::optional<View> viewFromText(const std::string& text, int width, int height) {
  View view;
  view.width = width;
  view.height = height;
  core::TextScanner scanner(text);
  double vertical = 0;
  Vec3 direction(0);
  bool hasType = false;
  const auto number = [&]() -> double {
    const auto word = scanner.word("");
    const auto value = word ? core::parseNumber(word->text) : std::nullopt;
    return value.value_or(std::nan(""));
  };
  while (const auto word = scanner.word("")) {
    if (word->text.size() == 4 && word->text.starts_with("-vt")) {
      const std::size_t type = std::string_view("vlae").find(word->text[3]);
      if (type == std::string_view::npos) return std::nullopt;
      view.projection = static_cast<Projection>(type);
      hasType = true;
    } else if (word->text == "-vp" || word->text == "-vd" || word->text == "-vu") {
      const double x = number(), y = number(), z = number();
      (word->text == "-vp" ? view.eye : word->text == "-vd" ? direction : view.up) = {x, y, z};
    } else if (word->text == "-vh") {
      (void)number();  // follows from the other and the picture's sides
    } else if (word->text == "-vv") {
      vertical = number();
    } else if (word->text == "-vs" || word->text == "-vl") {
      if (number() != 0) return std::nullopt;
    } else if (word->text == "-vo" || word->text == "-va") {
      (void)number();  // clipping planes
    }
  }
  const double sum = glm::length(view.eye) + glm::length(direction) + glm::length(view.up);
  if (!hasType || !std::isfinite(sum) || !(glm::length(direction) > 0) || !(vertical > 0 && vertical <= 360))
    return std::nullopt;
  if (view.projection == Projection::perspective && vertical >= 180) return std::nullopt;
  view.target = view.eye + direction;
  if (view.projection == Projection::orthographic)
    view.span = vertical;
  else
    view.verticalFov = vertical * core::degree;
  return view;
}

}  // namespace goniolux::scene
