#include "pipeline/radiance_luminaire.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <vector>

#include "geometry/queries.h"
#include "geometry/revolution.h"
#include "geometry/round_solid.h"
#include "geometry/sphere.h"
#include "geometry/tessellate.h"

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

geometry::Shape revolutionOf(const Opening& o) {
  return geometry::makeRevolution(o.profile, Vec3(0), Vec3(0, 0, 1));
}

// Projected area of the opening towards the emitted direction, in terms of ax, ay, az = |cosines| with its own axes.
std::string projectedArea(const Opening& o) {
  const Vec3 d = emitter::diametersOf(o);
  const double quarter = core::pi / 4;
  switch (o.shape) {
    case Shape::rectangle:
      return fmt::format("{:.12g}*az", o.length * o.width);
    case Shape::disc:
      return fmt::format("{:.12g}*az", quarter * d.x * d.y);
    case Shape::box:
      return fmt::format("({:.12g}*az+{:.12g}*ay+{:.12g}*ax)", o.length * o.width, o.length * o.height,
                         o.width * o.height);
    case Shape::cylinder:  // an ellipse seen along its plane is as wide as this root
      return fmt::format("({:.12g}*az+{:.12g}*root({:.12g}*ay*ay+{:.12g}*ax*ax))", quarter * d.x * d.y, o.height,
                         d.x * d.x, d.y * d.y);
    case Shape::sphere:  // an ellipsoid's shadow
      return fmt::format("{:.12g}*root({:.12g}*ax*ax+{:.12g}*ay*ay+{:.12g}*az*az)", quarter, d.y * d.y * d.z * d.z,
                         d.x * d.x * d.z * d.z, d.x * d.x * d.y * d.y);
    case Shape::point:
      return fmt::format("{:.12g}", quarter * pointDiameter * pointDiameter);
    case Shape::tube:
    case Shape::line: {
      const double diameter = o.shape == Shape::tube ? o.diameter : pointDiameter;
      const std::string along = cosine(o.axis);
      return fmt::format("({:.12g}*root(1-({})*({})))", o.length * diameter, along, along);
    }
    case Shape::revolution:
      return "1";  // in the table: luminance instead of intensity
  }
  return "1";
}

// Area of a convex surface of revolution seen at the angle gamma from its axis: half of what its facets show.
double revolutionShadow(const geometry::Mesh& mesh, double gamma) {
  const Vec3 to(std::sin(gamma), 0, std::cos(gamma));
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    sum += 0.25 * std::abs(glm::dot(glm::cross(b - a, c - a), to));
  }
  return sum;
}

// Area that emits, both sides of flat ones.
double wholeArea(const Opening& o) {
  const Vec3 d = emitter::diametersOf(o);
  core::Mat4 stretch(1.0);
  stretch[0][0] = d.x, stretch[1][1] = d.y;
  switch (o.shape) {
    case Shape::rectangle:
      return 2 * o.length * o.width;
    case Shape::disc:
      return core::pi / 2 * d.x * d.y;
    case Shape::box:
      return 2 * (o.length * o.width + o.length * o.height + o.width * o.height);
    case Shape::cylinder:
      return geometry::area(geometry::makeRoundSolid(Vec3(0), Vec3(0, 0, o.height), 0.5, 0.5, geometry::Caps::both),
                            stretch);
    case Shape::sphere:
      stretch[2][2] = d.z;
      return geometry::area(geometry::makeSphere(Vec3(0), 0.5), stretch);
    case Shape::tube:
      return core::pi * o.length * o.diameter;
    case Shape::line:
      return core::pi * o.length * pointDiameter;
    case Shape::point:
      return core::pi * pointDiameter * pointDiameter;
    case Shape::revolution:
      return geometry::area(revolutionOf(o));
  }
  return 1;
}

// Candelas over gamma and C, 0..180 and 0..360: at the table's own angles, so that Radiance's bilinear rule gives the
// same function; other distributions every 1 and 5 degrees.
std::string table(const photometry::IntensityDistribution& distribution, const Opening& opening) {
  const bool isRevolution = opening.shape == Shape::revolution;
  const geometry::Mesh mesh = isRevolution ? geometry::tessellate(revolutionOf(opening), 96) : geometry::Mesh{};
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
  if (isRevolution)
    for (int k = 0; k <= 180; ++k) gammas.insert(k);
  std::string text = fmt::format("2\n0 0 {}\n", gammas.size());
  for (const double g : gammas) text += fmt::format("{:.10g} ", g);
  text += fmt::format("\n0 0 {}\n", planes.size());
  for (const double c : planes) text += fmt::format("{:.10g} ", c);
  text += '\n';
  for (const double g : gammas) {
    const double shadow = isRevolution ? revolutionShadow(mesh, g * core::degree) : 1;
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
      text += fmt::format("{:.8g} ", candela / shadow);
    }
    text += '\n';
  }
  return text;
}

std::string functions(const scene::Luminaire& l) {
  const emitter::OpeningAxes own = emitter::axesOf(l.opening, l.frame);
  return fmt::format(
      "root(q) : sqrt(if(q, q, 0));\nclip(q) : if(q-1, 1, if(-1-q, -1, q));\n"
      "cx = {};\ncy = {};\ncz = {};\n"
      "ox = {};\noy = {};\noz = {};\n"
      "ax = root(ox*ox);\nay = root(oy*oy);\naz = root(oz*oz);\n"
      "gam = acos(clip(cz))*57.29577951308232;\n"
      "raw = atan2(cy, cx)*57.29577951308232;\nplane = if(raw, raw, raw+360);\n"
      "area = {};\nlum(v) = if(area-1e-12, v/area, 0);\n",
      cosine(l.frame.c0), cosine(l.frame.c90), cosine(l.frame.aim), cosine(own.x), cosine(own.y), cosine(own.z),
      projectedArea(l.opening));
}

}  // namespace

RadianceLuminaire radianceLuminaire(const scene::Luminaire& l, const std::string& name) {
  RadianceLuminaire result;
  result.modifier = "void";
  const double factor = l.maintenance * l.dimming;
  if (l.distribution) {
    result.files[name + ".dat"] = table(*l.distribution, l.opening);
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
