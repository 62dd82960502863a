// Luminous openings of LM-63. Sign patterns (width, length, height), from LM-63-1986 to -2019:
//   0 0 0 point · + + 0 rectangle · + + + box
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
  StatedOpening opening{Shape::other, l, w, h, false, ""};
  const auto round = [&](Shape shape, double diameter, double tall) {
    opening.shape = shape;
    opening.length = opening.width = diameter;
    opening.height = tall;
    return opening;
  };
  const auto other = [&](std::string note) {
    opening.note = std::move(note);
    return opening;
  };
  const auto horizontalCylinder = [&](double diameter, double across, double along, const char* direction) {
    const char* kind = isEqual(diameter, across) ? "horizontal cylinder" : "horizontal elliptical cylinder";
    return other(
        fmt::format("{} {} the 0-180 plane, length {:g} m, diameter {:g} m", kind, direction, along, diameter));
  };
  if (signs == "000") {
    opening.shape = Shape::point;
    return opening;
  }
  if (signs == "++0" || signs == "+++") {
    opening.shape = height > 0 ? Shape::box : Shape::rectangle;
    return opening;
  }
  if (signs == "-00" || signs == "0-0") return round(Shape::disc, std::max(w, l), 0);
  if (signs == "-0+" || signs == "0-+") return round(Shape::cylinder, std::max(w, l), h);
  if (signs == "--0")
    return isEqual(w, l) ? round(Shape::disc, w, 0) : other(fmt::format("ellipse {:g} m by {:g} m", l, w));
  if (signs == "--+") {
    return isEqual(w, l) ? round(Shape::cylinder, w, h)
                         : other(fmt::format("elliptical cylinder {:g} m by {:g} m, {:g} m high", l, w, h));
  }
  if (signs == "---") {
    return isEqual(w, l) && isEqual(w, h) ? round(Shape::sphere, w, w)
                                          : other(fmt::format("ellipsoid {:g} m by {:g} m by {:g} m", l, w, h));
  }
  if (signs == "-0-") {
    if (edition <= Lm63Edition::e1995 && isEqual(w, h)) return round(Shape::sphere, w, w);
    return other(fmt::format("upright disc facing the 0 degree plane, {:g} m wide, {:g} m high", w, h));
  }
  if (signs == "0+-") return horizontalCylinder(h, h, l, "along");
  if (signs == "+0-") return horizontalCylinder(h, h, w, "across");
  if (signs == "-+-" && edition >= Lm63Edition::e2002) return horizontalCylinder(w, h, l, "along");
  if (signs == "+--" && edition >= Lm63Edition::e2002) return horizontalCylinder(l, h, w, "across");
  if (signs == "-+0" || signs == "+-0") return other(fmt::format("ellipse {:g} m by {:g} m", l, w));
  if (signs == "-++" || signs == "+-+") {
    const char* kind = edition == Lm63Edition::e1995 ? "elliptical cylinder" : "ellipsoid";
    return other(fmt::format("{} {:g} m by {:g} m by {:g} m", kind, l, w, h));
  }
  if (signs == "-+-" || signs == "+--") return other(fmt::format("ellipsoid {:g} m by {:g} m by {:g} m", l, w, h));
  if (signs == "0+0" || signs == "+00" || signs == "00+") return other("line without width");
  if (signs == "0++" || signs == "+0+") return other("upright rectangle");
  return other("no shape that LM-63 knows");
}

}  // namespace goniolux::photometry
