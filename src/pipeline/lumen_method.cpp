#include "pipeline/lumen_method.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace goniolux::pipeline {

using core::Vec3;

namespace {

constexpr int mostLuminaires = 10'000;
constexpr double largestSpacingToHeight = 1.5;  // beyond it the plane is patchy under most luminaires

using Three = std::array<double, 3>;  // top, walls, bottom

// Flux that falls on each of three diffuse surfaces of a box, direct flux included. — radiosity, solved by iteration
Three incidentFlux(double length, double width, double height, const Three& reflectance, const Three& direct) {
  const double end = length * width, side = 2 * height * (length + width);
  const double across = oppositeRectangles(length, width, height);
  const double toWall = 1 - across, fromWall = toWall * end / side, wallToWall = 1 - 2 * fromWall;
  Three flux = direct;
  for (int bounce = 0; bounce < 500; ++bounce) {
    const Three out{reflectance[0] * flux[0], reflectance[1] * flux[1], reflectance[2] * flux[2]};
    flux = {direct[0] + out[1] * fromWall + out[2] * across,
            direct[1] + (out[0] + out[2]) * toWall + out[1] * wallToWall,
            direct[2] + out[1] * fromWall + out[0] * across};
  }
  return flux;
}

// What the part of the room below the work plane gives back of the flux that enters it.
double floorCavity(const RoomForLayout& room) {
  if (!(room.workPlane > 0)) return room.floor;
  const double across = oppositeRectangles(room.length, room.width, room.workPlane);
  return incidentFlux(room.length, room.width, room.workPlane, {0, room.walls, room.floor}, {0, 1 - across, across})[0];
}

// Share of a luminaire's flux that falls on the work plane directly. Midpoint rule after x = h sinh(u), which sets the
// points close below the luminaire however large the room is.
double directShare(const RoomForLayout& room, const photometry::IntensityDistribution& distribution, double x,
                   double y) {
  constexpr int steps = 48;
  const photometry::LuminaireFrame down;
  const double h = room.mounting - room.workPlane;
  const double lowX = std::asinh(-x / h), lowY = std::asinh(-y / h);
  const double stepX = (std::asinh((room.length - x) / h) - lowX) / steps,
               stepY = (std::asinh((room.width - y) / h) - lowY) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double u = lowX + (i + 0.5) * stepX;
    for (int j = 0; j < steps; ++j) {
      const double v = lowY + (j + 0.5) * stepY;
      const Vec3 to(h * std::sinh(u), h * std::sinh(v), -h);
      const double distance = glm::length(to);
      sum += distribution.intensity(down.toLocal(to / distance)) * h / (distance * distance * distance) *
             (h * std::cosh(u) * stepX) * (h * std::cosh(v) * stepY);
    }
  }
  const double flux = distribution.flux();
  return flux > 0 ? std::min(1.0, sum / flux) : 0;
}

}  // namespace

double oppositeRectangles(double a, double b, double c) {
  const double x = a / c, y = b / c, p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
  return 2 / (core::pi * x * y) *
         (0.5 * std::log(p * p * q * q / (1 + x * x + y * y)) + x * q * std::atan(x / q) + y * p * std::atan(y / p) -
          x * std::atan(x) - y * std::atan(y));
}

Layout lumenMethod(const RoomForLayout& room, const photometry::IntensityDistribution& distribution, int along,
                   int across) {
  const double stepX = room.length / along, stepY = room.width / across, h = room.mounting - room.workPlane;
  // All of them, or so many spread over the room that their mean is known.
  constexpr int mostCounted = 128;
  const int all = along * across, counted = std::min(all, mostCounted);
  double direct = 0;
  for (int i = 0; i < counted; ++i) {
    double ignored;
    const int k = counted == all ? i : static_cast<int>(std::modf((i + 0.5) * 0.6180339887498949, &ignored) * all);
    direct += directShare(room, distribution, (k % along + 0.5) * stepX, (k / along + 0.5) * stepY) / counted;
  }
  const double up = 1 - distribution.forwardFlux() / std::max(distribution.flux(), 1e-300);
  // The luminaires' plane is taken for the ceiling.
  const Three flux = incidentFlux(room.length, room.width, h, {room.ceiling, room.walls, floorCavity(room)},
                                  {up, std::max(0.0, 1 - up - direct), direct});
  Layout layout;
  layout.along = along;
  layout.across = across;
  layout.utilisation = flux[2];
  layout.meanIlluminance_lx = along * across * room.flux_lm * room.maintenance * flux[2] / (room.length * room.width);
  layout.roomIndex = room.length * room.width / (h * (room.length + room.width));
  layout.spacingToHeight = std::max(stepX, stepY) / h;
  return layout;
}

Layout layoutFor(const RoomForLayout& room, const photometry::IntensityDistribution& distribution, double target_lx) {
  const Layout one = lumenMethod(room, distribution, 1, 1);
  Layout best = one;
  double bestScore = HUGE_VAL;
  const double alone = std::max(one.meanIlluminance_lx, 1e-9);
  // Utilisation changes little with the layout: from fewer luminaires than the first guess says, upwards.
  int first = static_cast<int>(std::clamp(0.7 * target_lx / alone, 1.0, double(mostLuminaires)));
  for (int count = first; count <= mostLuminaires; ++count) {
    for (int along = 1; along <= count; ++along) {
      if (count % along != 0) continue;
      const int across = count / along;
      const double stepX = room.length / along, stepY = room.width / across;
      const double ratio = std::max(stepX, stepY) / std::min(stepX, stepY);
      const double far = std::max(stepX, stepY) / (room.mounting - room.workPlane) / largestSpacingToHeight;
      // A row is as good as a field in a corridor; else steps should be alike.
      const bool isRow = std::min(along, across) == 1;
      if (far > 1 || (ratio > 1.6 && !isRow && count > 3)) continue;
      const Layout layout = lumenMethod(room, distribution, along, across);
      if (layout.meanIlluminance_lx < target_lx || ratio >= bestScore) continue;
      best = layout;
      bestScore = ratio;
    }
    if (bestScore < HUGE_VAL) return best;
  }
  return best;
}

}  // namespace goniolux::pipeline
