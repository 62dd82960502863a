#include "emitter/near_field.h"

#include <algorithm>
#include <cmath>

namespace goniolux::emitter {

using core::Vec3;

namespace {

// The square -1..1 onto the unit disc, areas kept in proportion (Shirley and Chiu, 1997).
core::Vec2 concentric(const core::Vec2& p) {
  if (p.x == 0 && p.y == 0) return p;
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const double r = wide ? p.x : p.y;
  const double angle = wide ? 0.25 * core::pi * (p.y / p.x) : 0.5 * core::pi - 0.25 * core::pi * (p.x / p.y);
  return {r * std::cos(angle), r * std::sin(angle)};
}

}  // namespace

std::vector<Vec3> cutPlaces(const Opening& opening, const photometry::LuminaireFrame& frame, int n) {
  const OpeningAxes axes = axesOf(opening, frame);
  const bool flatLike = opening.shape != Opening::Shape::line && opening.shape != Opening::Shape::tube;
  const Vec3 along = flatLike ? axes.x : opening.axis, across = flatLike ? axes.y : Vec3(0);
  const Vec3 diameters = diametersOf(opening);
  const bool round = opening.shape == Opening::Shape::disc || opening.shape == Opening::Shape::cylinder ||
                     opening.shape == Opening::Shape::sphere;
  std::vector<Vec3> places;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const core::Vec2 place((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5);
      const core::Vec2 onDisc = concentric(2.0 * place);
      places.push_back(round ? along * (0.5 * diameters.x * onDisc.x) + across * (0.5 * diameters.y * onDisc.y)
                             : along * (opening.length * place.x) + across * (opening.width * place.y));
    }
  return places;
}

std::optional<double> cutError(const Opening& opening, const Output& output, double distance, int n) {
  const Vec3 origin(0), point = output.frame.aim * distance, facing = -output.frame.aim;
  const double exact = makeEmitter(opening, origin, output)->illuminance(point, facing, 1e-5).value;
  if (!(exact > 0)) return std::nullopt;
  Output part = output;
  part.scale /= n * n;
  part.flux_lm /= n * n;
  double sum = 0;
  for (const Vec3& at : cutPlaces(opening, output.frame, n))
    sum += makeEmitter({}, at, part)->illuminance(point, facing, 1e-5).value;
  return sum / exact - 1;
}

double largestExtent(const Opening& opening) {
  if (opening.shape == Opening::Shape::point) return 0;
  return std::max({opening.length, opening.width, opening.height, opening.diameter});
}

std::optional<double> pointModelFrom(const Opening& opening, const Output& output, double error) {
  const double size = largestExtent(opening);
  if (!(size > 0)) return std::nullopt;
  const auto isRight = [&](double distance) {
    const auto wrong = cutError(opening, output, distance, 1);
    return wrong && std::abs(*wrong) <= error;
  };
  constexpr double step = 1.05;
  double distance = 100 * size;
  if (!isRight(distance)) return std::nullopt;
  while (distance > 0.1 * size && isRight(distance / step)) distance /= step;
  return distance;
}

}  // namespace goniolux::emitter
