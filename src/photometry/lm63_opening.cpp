// Luminous openings of LM-63. Sign patterns (width, length, height), from LM-63-1986 to -2019; width lies across the
// 0-180 plane, length along it:
//   0 0 0 point · + + 0 rectangle · + + + box · 0 + + and + 0 + upright rectangles · one number alone: a line
//   1986, 1991: - 0 0 circle · - 0 + vertical cylinder · - + 0 ellipse · - + + ellipsoid
//   1995:       - 0 0 circle · - 0 + vertical cylinder · - 0 - sphere · 0 + - and + 0 - horizontal cylinders along and
//   across
//               photometric horizontal · - + + and + - + elliptical vertical cylinders · - + - and + - - ellipsoids
//   2002, 2019: - - 0 circle or ellipse · - - + vertical cylinder · - - - sphere or ellipsoid · - + - and + - -
//   horizontal cylinders
//               along and across photometric horizontal · - 0 - vertical circle facing photometric horizontal
#include <fmt/format.h>

#include <cmath>

#include "photometry/lm63.h"

namespace goniolux::photometry {
namespace {

using Shape = StatedOpening::Shape;
using Axis = StatedOpening::Axis;

char sign(double value) {
  return value < 0 ? '-' : value > 0 ? '+' : '0';
}

bool isEqual(double a, double b) {
  return std::abs(a - b) <= 1e-6 * std::max(a, b);
}

}  // namespace

StatedOpening lm63Opening(Lm63Edition edition, double width, double length, double height, double metresPerUnit) {
  const double w = std::abs(width) * metresPerUnit, l = std::abs(length) * metresPerUnit,
               h = std::abs(height) * metresPerUnit;
  const char pattern[] = {sign(width), sign(length), sign(height), '\0'};
  const std::string signs = pattern;
  const auto made = [&](Shape shape, Axis axis, double alongC0, double across, double tall) {
    StatedOpening opening;
    opening.shape = shape;
    opening.axis = axis;
    opening.length = alongC0;
    opening.width = across;
    opening.height = tall;
    return opening;
  };
  const double round = std::max(w, l);
  if (signs == "000") return {};
  if (signs == "++0") return made(Shape::rectangle, Axis::aim, l, w, 0);
  if (signs == "+++") return made(Shape::box, Axis::aim, l, w, h);
  if (signs == "0++") return made(Shape::rectangle, Axis::widthwise, l, 0, h);
  if (signs == "+0+") return made(Shape::rectangle, Axis::lengthwise, 0, w, h);
  if (signs == "0+0" || signs == "+00" || signs == "00+") return made(Shape::line, Axis::aim, l, w, h);
  if (signs == "-00" || signs == "0-0") return made(Shape::disc, Axis::aim, round, round, 0);
  if (signs == "-0+" || signs == "0-+") return made(Shape::cylinder, Axis::aim, round, round, h);
  if (signs == "--0" || signs == "-+0" || signs == "+-0") return made(Shape::disc, Axis::aim, l, w, 0);
  if (signs == "--+") return made(Shape::cylinder, Axis::aim, l, w, h);
  if (signs == "---") return made(Shape::sphere, Axis::aim, l, w, h);
  if (signs == "-0-") {
    if (edition <= Lm63Edition::e1995 && isEqual(w, h)) return made(Shape::sphere, Axis::aim, w, w, w);
    return made(Shape::disc, Axis::lengthwise, 0, w, h);
  }
  if (signs == "0--") return made(Shape::disc, Axis::widthwise, l, 0, h);
  if (signs == "0+-") return made(Shape::cylinder, Axis::lengthwise, l, h, h);
  if (signs == "+0-") return made(Shape::cylinder, Axis::widthwise, h, w, h);
  if (signs == "-+-" && edition >= Lm63Edition::e2002) return made(Shape::cylinder, Axis::lengthwise, l, w, h);
  if (signs == "+--" && edition >= Lm63Edition::e2002) return made(Shape::cylinder, Axis::widthwise, l, w, h);
  if ((signs == "-++" || signs == "+-+") && edition >= Lm63Edition::e1995)
    return made(Shape::cylinder, Axis::aim, l, w, h);
  if (signs == "-++" || signs == "+-+" || signs == "-+-" || signs == "+--")
    return made(Shape::sphere, Axis::aim, l, w, h);
  StatedOpening other = made(Shape::other, Axis::aim, l, w, h);
  other.note = fmt::format("width {:g}, length {:g}, height {:g} is no shape that LM-63 knows", width, length, height);
  return other;
}

}  // namespace goniolux::photometry
