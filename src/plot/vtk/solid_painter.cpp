#include "plot/vtk/solid_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plot/levels.h"
#include "plot/number_text.h"

namespace goniolux::plot {
namespace {

using core::Vec2;
using core::Vec3;
using Align = TextStyle::Align;

// Seen from above and in front: C0 to the right and towards the reader, C90 to the right and away.
const double turn = 30 * core::degree, tilt = 22 * core::degree;
const Vec3 light = glm::normalize(Vec3(-0.4, 0.5, 0.75));  // page frame: right, up, towards the reader
constexpr double left = 40, top = 150, bottom = 110;
constexpr double shadow = 0.72;
constexpr double finestColour = 0.02;  // step of the intensity, of the largest, that a strip of one colour may span
constexpr double planeHalf = 0.5, axisLength = 0.62;  // in units of the largest intensity

// Page frame of a direction (C0, C90, up).
Vec3 toPage(const Vec3& p) {
  const double right = p.x * std::cos(turn) + p.y * std::sin(turn), away = p.y * std::cos(turn) - p.x * std::sin(turn);
  return {right, p.z * std::cos(tilt) + away * std::sin(tilt), p.z * std::sin(tilt) - away * std::cos(tilt)};
}

}  // namespace

SolidPainter::SolidPainter(const PhotometricSolid& solid) : solid_(solid) {
  largest_ = std::max(*std::max_element(solid.values.begin(), solid.values.end()), 1e-300);
  Vec3 low(0), high(0);
  for (std::size_t h = 0; h < solid.planes.size(); ++h)
    for (std::size_t v = 0; v < solid.gammas.size(); ++v) {
      const Vec3 page = toPage(corner(h, v));
      low = glm::min(low, page);
      high = glm::max(high, page);
    }
  for (const double sign : {-1.0, 1.0})
    for (const Vec3& at : {Vec3(sign * axisLength, 0, 0), Vec3(0, sign * axisLength, 0),
                           Vec3(sign * planeHalf, sign * planeHalf, 0), Vec3(sign * planeHalf, -sign * planeHalf, 0)}) {
      low = glm::min(low, toPage(at));
      high = glm::max(high, toPage(at));
    }
  const Vec2 room(width() - 2 * left - 120, height() - top - bottom - 60);
  scale_ = std::min(room.x / std::max(high.x - low.x, 0.4), room.y / std::max(high.y - low.y, 0.4));
  origin_ = Vec2(0.5 * width(), bottom + 30 + 0.5 * room.y) - 0.5 * scale_ * Vec2(low.x + high.x, low.y + high.y);
}

Vec3 SolidPainter::corner(std::size_t plane, std::size_t gamma) const {
  const double c = solid_.planes[plane] * core::degree, g = solid_.gammas[gamma] * core::degree;
  const double r = solid_.values[plane * solid_.gammas.size() + gamma] / largest_;
  return r * Vec3(std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g));
}

Vec3 SolidPainter::projected(const Vec3& point) const {
  const Vec3 page = toPage(point);
  return {origin_.x + scale_ * page.x, origin_.y + scale_ * page.y, page.z};
}

void SolidPainter::paintAxis(Ink& ink, const Vec3& direction, const char* name) const {
  const Vec3 end = projected(direction);
  ink.line({origin_, {end.x, end.y}}, grey, 1.4);
  const Vec2 outwards = Vec2(end.x, end.y) - origin_;
  const TextStyle style{16, true, grey, 0, Align::center};
  const Vec2 place = Vec2(end.x, end.y) + outwards * (26 / std::max(glm::length(outwards), 1.0));
  const Vec2 room = textSize(name, style) / 2.0 + 3.0;
  ink.rectangle(place - room, place + room, white, 220);  // it may stand before the solid
  ink.text(name, place, style);
}

void SolidPainter::paint(Ink& ink) const {
  const double high = height();
  ink.text(solid_.title, {left, high - 44}, fitting(solid_.title, {28, true}, width() - 2 * left));
  ink.text(solid_.subtitle, {left, high - 82}, fitting(solid_.subtitle, {18, false, grey}, width() - 2 * left));
  std::string facts;
  for (const std::string& fact : solid_.facts) facts += (facts.empty() ? "" : "     ") + fact;
  ink.text(facts, {left, high - 116}, fitting(facts, {17}, width() - 2 * left));
  // The plane of the luminaire, as a square with the two axes.
  const double half = planeHalf;
  Polyline square;
  for (const Vec3& at : {Vec3(-half, -half, 0), Vec3(half, -half, 0), Vec3(half, half, 0), Vec3(-half, half, 0)}) {
    const Vec3 page = projected(at);
    square.emplace_back(page.x, page.y);
  }
  struct Facet {
    double depth;
    Polyline corners;
    Rgb colour;
  };
  std::vector<Facet> below, above;
  const Palette& palette = *findPalette("viridis");
  for (std::size_t h = 0; h + 1 < solid_.planes.size(); ++h)
    for (std::size_t v = 0; v + 1 < solid_.gammas.size(); ++v) {
      const Vec3 cell[] = {corner(h, v), corner(h, v + 1), corner(h + 1, v + 1), corner(h + 1, v)};
      // In strips where the intensity changes much, so that colours go over into each other.
      const double change = std::max(std::abs(glm::length(cell[1]) - glm::length(cell[0])),
                                     std::abs(glm::length(cell[2]) - glm::length(cell[3])));
      const int strips = 1 + static_cast<int>(change / finestColour);
      for (int strip = 0; strip < strips; ++strip) {
        const double from = static_cast<double>(strip) / strips, to = static_cast<double>(strip + 1) / strips;
        const Vec3 corners[] = {glm::mix(cell[0], cell[1], from), glm::mix(cell[0], cell[1], to),
                                glm::mix(cell[3], cell[2], to), glm::mix(cell[3], cell[2], from)};
        const Vec3 across = glm::cross(corners[2] - corners[0], corners[3] - corners[1]);
        if (glm::length(across) < 1e-12) continue;
        Vec3 normal = toPage(across);
        normal = glm::normalize(normal.z < 0 ? -normal : normal);
        // Light enough that colours are still those of the legend.
        const double shade = shadow + (1 - shadow) * std::max(0.0, glm::dot(normal, light));
        double radius = 0;
        Facet facet{0, {}, {}};
        for (const Vec3& at : corners) {
          const Vec3 page = projected(at);
          facet.corners.emplace_back(page.x, page.y);
          facet.depth += page.z;
          radius += 0.25 * glm::length(at);
        }
        const Rgb base = colourAt(palette, radius);
        for (std::size_t i = 0; i < 3; ++i) facet.colour[i] = static_cast<std::uint8_t>(std::lround(base[i] * shade));
        (solid_.gammas[v] + solid_.gammas[v + 1] > 180 ? above : below).push_back(std::move(facet));
      }
    }
  const auto paintAll = [&](std::vector<Facet>& facets) {
    std::stable_sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) { return a.depth < b.depth; });
    for (const Facet& facet : facets) {
      ink.area(facet.corners, facet.colour);
      Polyline edge = facet.corners;
      edge.push_back(edge.front());
      ink.line(edge, facet.colour, 0.8);  // no white seams between neighbours
    }
  };
  // Seen from above: what lies below the luminaire's plane is behind it.
  paintAll(below);
  square.push_back(square.front());
  ink.line(square, grey, 1);
  paintAxis(ink, {axisLength, 0, 0}, "C0");
  paintAxis(ink, {0, axisLength, 0}, "C90");
  paintAxis(ink, {-axisLength, 0, 0}, "C180");
  paintAxis(ink, {0, -axisLength, 0}, "C270");
  paintAll(above);
  // Colours by intensity: round values, and the largest at the end of the bar.
  const double barLeft = left, barWidth = 420, barLow = 66, barHigh = 84;
  constexpr int steps = 84;
  for (int i = 0; i < steps; ++i)
    ink.rectangle({barLeft + barWidth * i / steps, barLow}, {barLeft + barWidth * (i + 1) / steps + 0.5, barHigh},
                  colourAt(palette, (i + 0.5) / steps));
  const TextStyle plain{15, false, black, 0, Align::center};
  const std::string end = fmt::format("{} {}", levelText(largest_), solid_.unit);
  const double endLeft = barLeft + barWidth - textSize(levelText(largest_), plain).x;
  for (const double tick : axisTicks(0, largest_, 4)) {
    const double x = barLeft + barWidth * tick / largest_;
    if (x + textSize(levelText(tick), plain).x > endLeft) continue;
    ink.line({{x, barLow - 5}, {x, barLow}}, grey, 1);
    ink.text(levelText(tick), {x, 50}, tick == 0 ? TextStyle{15, false, black, 0, Align::left} : plain);
  }
  ink.line({{barLeft + barWidth, barLow - 5}, {barLeft + barWidth, barLow}}, grey, 1);
  ink.text(end, {endLeft, 50}, {15, false, black, 0, Align::left});
  ink.text(solid_.footer, {left, 22}, fitting(solid_.footer, {12, false, grey}, width() - 2 * left));
}

}  // namespace goniolux::plot
