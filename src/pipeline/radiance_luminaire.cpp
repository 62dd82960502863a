#include "pipeline/radiance_luminaire.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <vector>

namespace goniolux::pipeline {
namespace {

using core::Vec3;
using emitter::Opening;
using Shape = Opening::Shape;

constexpr double pointDiameter = 0.002;  // m

// Cosine between the emitted direction, which Radiance calls -D, and an axis.
std::string cosine(const Vec3& axis) {
  return fmt::format("-(Dx*{:.12g}+Dy*{:.12g}+Dz*{:.12g})", axis.x, axis.y, axis.z);
}

// Projected area of the opening towards the emitted direction, in terms of ax, ay, az = |cosines| with C0, C90, aim.
std::string projectedArea(const Opening& o) {
  const double disc = core::pi / 4 * o.diameter * o.diameter;
  switch (o.shape) {
    case Shape::rectangle:
      return fmt::format("{:.12g}*az", o.length * o.width);
    case Shape::disc:
      return fmt::format("{:.12g}*az", disc);
    case Shape::box:
      return fmt::format("({:.12g}*az+{:.12g}*ay+{:.12g}*ax)", o.length * o.width, o.length * o.height,
                         o.width * o.height);
    case Shape::cylinder:
      return fmt::format("({:.12g}*az+{:.12g}*root(1-az*az))", disc, o.diameter * o.height);
    case Shape::sphere:
      return fmt::format("{:.12g}", disc);
    case Shape::point:
      return fmt::format("{:.12g}", core::pi / 4 * pointDiameter * pointDiameter);
    case Shape::tube:
    case Shape::line: {
      const double diameter = o.shape == Shape::tube ? o.diameter : pointDiameter;
      const std::string along = cosine(o.axis);
      return fmt::format("({:.12g}*root(1-({})*({})))", o.length * diameter, along, along);
    }
  }
  return "1";
}

// Area that emits, both sides of flat ones.
double wholeArea(const Opening& o) {
  switch (o.shape) {
    case Shape::rectangle:
      return 2 * o.length * o.width;
    case Shape::disc:
      return core::pi / 2 * o.diameter * o.diameter;
    case Shape::box:
      return 2 * (o.length * o.width + o.length * o.height + o.width * o.height);
    case Shape::cylinder:
      return core::pi * o.diameter * (o.diameter / 2 + o.height);
    case Shape::sphere:
      return core::pi * o.diameter * o.diameter;
    case Shape::tube:
      return core::pi * o.length * o.diameter;
    case Shape::line:
      return core::pi * o.length * pointDiameter;
    case Shape::point:
      return core::pi * pointDiameter * pointDiameter;
  }
  return 1;
}

// Candelas over gamma and C, 0..180 and 0..360: at the table's own angles, so that Radiance's bilinear rule gives the
// same function; other distributions every 1 and 5 degrees.
std::string table(const photometry::IntensityDistribution& distribution) {
  std::set<double> gammas, planes;
  const auto* own = dynamic_cast<const photometry::TabulatedDistribution*>(&distribution);
  if (own && own->type() == photometry::PhotometryType::c) {
    for (const double c : own->horizontalAngles())
      for (const double copy : {c, 360 - c, 180 - c, 180 + c, 540 - c}) planes.insert(std::fmod(copy + 360, 360));
    planes.insert({0, 360});
    const auto& stated = own->verticalAngles();
    gammas.insert(stated.begin(), stated.end());
    // Nothing beyond the stated angles.
    if (stated.front() > 0) gammas.insert({0.0, stated.front() - 1e-4});
    if (stated.back() < 180) gammas.insert({stated.back() + 1e-4, 180.0});
  } else {
    for (int k = 0; k <= 180; ++k) gammas.insert(k);
    gammas.insert({89.9999, 90.0001});
    for (int k = 0; k <= 360; k += 5) planes.insert(k);
  }
  std::string text = fmt::format("2\n0 0 {}\n", gammas.size());
  for (const double g : gammas) text += fmt::format("{:.10g} ", g);
  text += fmt::format("\n0 0 {}\n", planes.size());
  for (const double c : planes) text += fmt::format("{:.10g} ", c);
  text += '\n';
  for (const double g : gammas) {
    for (const double c : planes) {
      double candela = 0;
      if (own && own->type() == photometry::PhotometryType::c) {
        const auto& stated = own->verticalAngles();
        candela = g < stated.front() || g > stated.back() ? 0 : own->atAngles(c, g);
      } else {
        const double s = std::sin(g * core::degree);
        candela = distribution.intensity(
            {s * std::cos(c * core::degree), s * std::sin(c * core::degree), std::cos(g * core::degree)});
      }
      text += fmt::format("{:.8g} ", candela);
    }
    text += '\n';
  }
  return text;
}

std::string functions(const scene::Luminaire& l) {
  return fmt::format(
      "root(q) : sqrt(if(q, q, 0));\nclip(q) : if(q-1, 1, if(-1-q, -1, q));\n"
      "cx = {};\ncy = {};\ncz = {};\n"
      "ax = root(cx*cx);\nay = root(cy*cy);\naz = root(cz*cz);\n"
      "gam = acos(clip(cz))*57.29577951308232;\n"
      "raw = atan2(cy, cx)*57.29577951308232;\nplane = if(raw, raw, raw+360);\n"
      "area = {};\nlum(v) = if(area-1e-12, v/area, 0);\n",
      cosine(l.frame.c0), cosine(l.frame.c90), cosine(l.frame.aim), projectedArea(l.opening));
}

}  // namespace

RadianceLuminaire radianceLuminaire(const scene::Luminaire& l, const std::string& name) {
  RadianceLuminaire result;
  result.modifier = "void";
  const double factor = l.maintenance * l.dimming;
  if (l.distribution) {
    result.files[name + ".dat"] = table(*l.distribution);
    result.files[name + ".cal"] = functions(l);
    result.modifier = name + "_p";
    result.pattern = fmt::format("void brightdata {0}_p 5 lum {0}.dat {0}.cal gam plane 0 0\n", name);
    result.luminance = l.scale * factor;
  } else {
    result.luminance = l.flux_lm * factor / (core::pi * wholeArea(l.opening));
  }
  const Vec3 p = l.center;
  if (l.opening.shape == Shape::point)
    result.geometry = fmt::format("{0} sphere {0}_s 0 0 4 {1:.10g} {2:.10g} {3:.10g} {4:.10g}\n", name, p.x, p.y, p.z,
                                  pointDiameter / 2);
  if (l.opening.shape == Shape::line) {
    const Vec3 half = 0.5 * l.opening.length * l.opening.axis, a = p - half, b = p + half;
    result.geometry =
        fmt::format("{0} cylinder {0}_s 0 0 7 {1:.10g} {2:.10g} {3:.10g} {4:.10g} {5:.10g} {6:.10g} {7:.10g}\n", name,
                    a.x, a.y, a.z, b.x, b.y, b.z, pointDiameter / 2);
  }
  return result;
}

}  // namespace goniolux::pipeline
