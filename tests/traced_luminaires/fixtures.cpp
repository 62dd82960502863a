// The fixtures of luminaires/traced-*: plain models of common luminaires, no manufacturer's product.
#include <cmath>

#include "traced_luminaires/fixture.h"
#include "traced_luminaires/shapes.h"

namespace goniolux::traced {
namespace {

using core::Vec2;
using core::Vec3;
using Opening = photometry::StatedOpening;

std::vector<double> steps(double first, double last, double step) {
  std::vector<double> list;
  for (int i = 0; first + i * step <= last + 1e-9; ++i) list.push_back(first + i * step);
  return list;
}

Opening openingOf(Opening::Shape shape, double length, double width, double height, bool alongC90 = false) {
  Opening opening;
  opening.shape = shape;
  opening.length = length;
  opening.width = width;
  opening.height = height;
  opening.lengthAlongC90 = alongC90;
  return opening;
}

constexpr const char* ledWhite = "CIE LED-B3";
constexpr const char* ledWarm = "CIE LED-B2";

// A COB at the focus of a parabola that is cut off there; light leaves at z = 0.
std::vector<Part> parabolicReflector(double exitRadius, double focalLength) {
  const double depth = exitRadius * exitRadius / (4 * focalLength), neck = depth - focalLength;
  std::vector<Vec2> profile;
  constexpr int segments = 32;
  for (int i = 0; i <= segments; ++i) {
    const double z = neck * i / segments;
    profile.emplace_back(std::sqrt(4 * focalLength * (depth - z)), z);
  }
  return {{turned(profile), Finish::mirror, 0.88}, {disc({0, 0, neck + 1e-4}, 2 * focalLength), Finish::diffuse, 0.8}};
}

Fixture parabolicDownlight() {
  Fixture f;
  f.file = "traced-downlight-parabolic.ies";
  f.title = "Recessed LED downlight, parabolic reflector";
  f.use = "foyers, double height";
  f.how = "COB of 18 mm at the focus (12 mm) of a parabola 120 mm wide, reflectance 0.88, polyline of 32 frusta";
  f.lampFlux = 2000;
  f.watts = 18;
  f.spectrum = ledWarm;
  f.opening = openingOf(Opening::Shape::disc, 0.12, 0.12, 0);
  f.planes = {0};
  f.gammas = steps(0, 90, 2.5);
  f.parts = parabolicReflector(0.06, 0.012);
  f.lamps = {{.kind = Lamp::Kind::disc, .center = {0, 0, 0.0629}, .diameter = 0.018}};
  return f;
}

Fixture baffleDownlight() {
  Fixture f;
  f.file = "traced-downlight-baffle.ldt";
  f.title = "Recessed downlight, opal disc above a white baffle";
  f.use = "corridors, wash rooms";
  f.how = "opal disc of 110 mm, 80 mm above the ceiling; white cone, reflectance 0.8, 160 mm wide";
  f.lampFlux = 1500;
  f.watts = 14;
  f.spectrum = ledWhite;
  f.opening = openingOf(Opening::Shape::disc, 0.16, 0.16, 0);
  f.planes = {0};
  f.gammas = steps(0, 90, 2.5);
  f.parts = {{turned({{0.08, 0}, {0.055, 0.08}}), Finish::diffuse, 0.8},
             {disc({0, 0, 0.0801}, 0.0551), Finish::diffuse, 0.8}};
  f.lamps = {{.kind = Lamp::Kind::disc, .center = {0, 0, 0.08}, .diameter = 0.11}};
  return f;
}

Fixture troughBatten() {
  Fixture f;
  f.file = "traced-batten-reflector.ldt";
  f.title = "Industrial batten 1 x 58 W T8 with white reflector";
  f.use = "workshops, stores";
  f.how =
      "tube of 1.5 m in a white trough, reflectance 0.82, 180 mm wide; the tube reflects 0.75; ends open, no end "
      "effects of the tube";
  f.lampFlux = 5000;
  f.watts = 55;
  f.absolute = false;
  f.lamp = "1 x T8 58 W, triphosphor";
  f.spectrum = "CIE FL11";
  f.opening = openingOf(Opening::Shape::rectangle, 1.5, 0.18, 0, true);
  f.planes = steps(0, 90, 15);
  f.gammas = steps(0, 180, 5);
  f.parts = {{trough({{-0.09, 0}, {-0.035, 0.06}, {0.035, 0.06}, {0.09, 0}}, 1.5, true, false), Finish::diffuse, 0.82},
             {tube({0, 0, 0.03}, {0, 1, 0}, 1.48, 0.0259), Finish::diffuse, 0.75}};
  f.lamps = {{.kind = Lamp::Kind::tube, .center = {0, 0, 0.03}, .along = {0, 1, 0}, .length = 1.48, .diameter = 0.026}};
  return f;
}

Fixture louvre() {
  Fixture f;
  f.file = "traced-louvre-2x28.ies";
  f.title = "Recessed louvre 2 x 28 W T5, specular blades";
  f.use = "offices with screens";
  f.how =
      "two tubes in a white box; blades of aluminium, reflectance 0.87, 50 mm high, every 100 mm, and plates between "
      "and "
      "beside the lamps";
  f.lampFlux = 5200;
  f.watts = 61;
  f.absolute = false;
  f.lamp = "2 x T5 28 W, triphosphor";
  f.spectrum = "CIE FL11";
  f.opening = openingOf(Opening::Shape::rectangle, 1.2, 0.3, 0);
  f.planes = steps(0, 90, 15);
  f.gammas = steps(0, 90, 5);
  f.parts = {{trough({{-0.15, 0}, {-0.15, 0.1}, {0.15, 0.1}, {0.15, 0}}, 1.2, false, true), Finish::diffuse, 0.85}};
  std::vector<Vec3> blades;
  const auto plate = [&](const Vec3& a, const Vec3& b) {
    blades.insert(blades.end(), {a, b, b + Vec3(0, 0, 0.05), a + Vec3(0, 0, 0.05)});
  };
  for (int i = -5; i <= 5; ++i) plate({0.1 * i, -0.149, 0}, {0.1 * i, 0.149, 0});
  for (const double y : {-0.149, 0.0, 0.149}) plate({-0.599, y, 0}, {0.599, y, 0});
  f.parts.push_back({quads(blades), Finish::mirror, 0.87});
  for (const double y : {-0.075, 0.075}) {
    f.parts.push_back({tube({0, y, 0.075}, {1, 0, 0}, 1.15, 0.0159), Finish::diffuse, 0.75});
    f.lamps.push_back({.kind = Lamp::Kind::tube,
                       .center = {0, y, 0.075},
                       .along = {1, 0, 0},
                       .length = 1.15,
                       .diameter = 0.016,
                       .share = 0.5});
  }
  return f;
}

Fixture wallWasher() {
  Fixture f;
  f.file = "traced-wall-washer.ies";
  f.title = "Recessed linear wall washer, throw towards C90";
  f.use = "shelves, boards, even walls";
  f.how = "T5 tube at the focus (20 mm) of a parabolic trough, reflectance 0.88, its axis 35 degrees off the nadir";
  f.lampFlux = 2600;
  f.watts = 31;
  f.absolute = false;
  f.lamp = "1 x T5 28 W, triphosphor";
  f.spectrum = "CIE FL11";
  f.opening = openingOf(Opening::Shape::rectangle, 1.15, 0.12, 0);
  f.planes = steps(90, 270, 15);
  f.gammas = steps(0, 180, 5);
  f.parts = {{trough(parabola({0, 0.05}, 0.02, 35, 80, 280, 40), 1.15, false, false), Finish::mirror, 0.88},
             {tube({0, 0, 0.05}, {1, 0, 0}, 1.14, 0.0159), Finish::diffuse, 0.75}};
  f.lamps = {{.kind = Lamp::Kind::tube, .center = {0, 0, 0.05}, .along = {1, 0, 0}, .length = 1.14, .diameter = 0.016}};
  return f;
}

Fixture highBay() {
  Fixture f;
  f.file = "traced-high-bay.ies";
  f.title = "LED high bay with a reflector of sixteen facets";
  f.use = "halls from 8 m";
  f.how =
      "LED disc of 180 mm; sixteen flat facets of aluminium, reflectance 0.85, from 200 to 480 mm over 200 mm; mean "
      "over C";
  f.lampFlux = 24000;
  f.watts = 165;
  f.spectrum = ledWhite;
  f.opening = openingOf(Opening::Shape::disc, 0.48, 0.48, 0);
  f.planes = {0};
  f.gammas = steps(0, 90, 2.5);
  std::vector<Vec3> facets;
  constexpr int count = 16;
  for (int i = 0; i < count; ++i) {
    const auto at = [](double r, int k, double z) {
      const double angle = 2 * core::pi * k / count;
      return Vec3(r * std::cos(angle), r * std::sin(angle), z);
    };
    facets.insert(facets.end(), {at(0.1, i, 0.2), at(0.1, i + 1, 0.2), at(0.24, i + 1, 0), at(0.24, i, 0)});
  }
  f.parts = {{quads(facets), Finish::mirror, 0.85}, {disc({0, 0, 0.2001}, 0.1), Finish::diffuse, 0.8}};
  f.lamps = {{.kind = Lamp::Kind::disc, .center = {0, 0, 0.2}, .diameter = 0.18}};
  return f;
}

Fixture opalBox() {
  Fixture f;
  f.file = "traced-opal-panel.xml";
  f.title = "LED panel 600 x 600, opal cover over a white box";
  f.use = "schools, corridors; the TM-33 file carries its spectrum";
  f.how = "LED board 60 mm above an opal cover (reflects 0.45, transmits 0.5); box reflectance 0.9, board 0.85";
  f.lampFlux = 6400;
  f.watts = 36;
  f.spectrum = ledWhite;
  f.opening = openingOf(Opening::Shape::rectangle, 0.596, 0.596, 0);
  f.planes = steps(0, 90, 15);
  f.gammas = steps(0, 90, 5);
  f.parts = {{rectangle({0, 0, 0.0001}, {0.299, 0, 0}, {0, 0.299, 0}), Finish::diffuser, 0.45, 0.5},
             {trough({{-0.3, 0}, {-0.3, 0.06}, {0.3, 0.06}, {0.3, 0}}, 0.6, false, true), Finish::diffuse, 0.9}};
  f.lamps = {
      {.kind = Lamp::Kind::rectangle, .center = {0, 0, 0.0599}, .along = {1, 0, 0}, .length = 0.56, .width = 0.56}};
  return f;
}

Fixture bollard() {
  Fixture f;
  f.file = "traced-bollard-louvre.ldt";
  f.title = "Bollard with a cone reflector and black rings";
  f.use = "paths, gardens";
  f.how = "opal globe of 50 mm under a mirror cone (0.85); three black rings of 140 mm around it";
  f.lampFlux = 900;
  f.watts = 9;
  f.spectrum = ledWarm;
  f.opening = openingOf(Opening::Shape::cylinder, 0.14, 0.14, 0.12);
  f.planes = {0};
  f.gammas = steps(0, 180, 5);
  f.parts = {{turned({{0.005, 0.035}, {0.07, 0.065}}), Finish::mirror, 0.85},
             {disc({0, 0, 0.066}, 0.075), Finish::black},
             {disc({0, 0, -0.065}, 0.07), Finish::black},
             {sphere({0, 0, 0}, 0.0249), Finish::diffuse, 0.7}};
  for (const double z : {-0.04, -0.01, 0.02})
    f.parts.push_back({turned({{0.05, z}, {0.07, z + 0.004}}), Finish::black});
  f.lamps = {{.kind = Lamp::Kind::sphere, .center = {0, 0, 0}, .diameter = 0.05}};
  return f;
}

Fixture cove() {
  Fixture f;
  f.file = "traced-cove.ies";
  f.title = "Cove trough 1 x 35 W T5, halophosphate retro, light up and towards C90";
  f.use = "ceilings from a cove";
  f.how = "tube in a white trough, reflectance 0.85, open above, its back 40 mm higher than its front";
  f.lampFlux = 3300;
  f.watts = 39;
  f.absolute = false;
  f.lamp = "1 x T5 35 W";
  f.spectrum = "CIE FL2";
  f.opening = openingOf(Opening::Shape::rectangle, 1.45, 0.13, 0);
  f.planes = steps(90, 270, 15);
  f.gammas = steps(0, 180, 5);
  f.parts = {
      {trough({{-0.05, 0.04}, {-0.05, -0.05}, {0.08, -0.05}, {0.08, 0}}, 1.45, false, false), Finish::diffuse, 0.85},
      {tube({0, 0, -0.02}, {1, 0, 0}, 1.44, 0.0159), Finish::diffuse, 0.75}};
  f.lamps = {
      {.kind = Lamp::Kind::tube, .center = {0, 0, -0.02}, .along = {1, 0, 0}, .length = 1.44, .diameter = 0.016}};
  return f;
}

Fixture spotWithDoors() {
  Fixture f;
  f.file = "traced-spot-barn-doors.ies";
  f.title = "Track spot with four barn doors, unequal";
  f.use = "galleries: a beam cut to a picture";
  f.how =
      "COB of 22 mm at the focus (12 mm) of a parabola 90 mm wide, reflectance 0.88; black doors of 60 mm at 2, 25, 8 "
      "and 15 "
      "degrees from the axis (C0, C90, C180, C270)";
  f.lampFlux = 1800;
  f.watts = 17;
  f.spectrum = ledWarm;
  f.opening = openingOf(Opening::Shape::disc, 0.09, 0.09, 0);
  f.planes = steps(0, 345, 15);
  f.gammas = steps(0, 24, 1.5);
  for (const double gamma : steps(27.5, 90, 2.5)) f.gammas.push_back(gamma);
  f.parts = parabolicReflector(0.045, 0.012);
  const double angles[] = {2, 25, 8, 15};
  for (int side = 0; side < 4; ++side) {
    const double c = 0.5 * core::pi * side, lean = angles[side] * core::degree;
    const Vec3 out(std::cos(c), std::sin(c), 0), across(-std::sin(c), std::cos(c), 0);
    const Vec3 door = (out * std::sin(lean) + Vec3(0, 0, -std::cos(lean))) * 0.03;
    f.parts.push_back({rectangle(out * 0.047 + door, door, across * 0.045), Finish::black});
  }
  f.lamps = {{.kind = Lamp::Kind::disc, .center = {0, 0, 0.0301}, .diameter = 0.022}};
  return f;
}

Fixture pendant() {
  Fixture f;
  f.file = "traced-pendant-up-down.ldt";
  f.title = "Linear LED pendant, opal below, open above";
  f.use = "meeting rooms, offices";
  f.how =
      "boards down behind an opal cover (reflects 0.4, transmits 0.55) and up without cover, 45 % of the light; white "
      "profile 60 x 60 mm, 1.2 m";
  f.lampFlux = 5600;
  f.watts = 40;
  f.spectrum = ledWhite;
  f.opening = openingOf(Opening::Shape::box, 1.2, 0.06, 0.06, true);
  f.planes = steps(0, 90, 15);
  f.gammas = steps(0, 180, 5);
  f.parts = {{trough({{-0.03, 0}, {-0.03, 0.06}}, 1.2, true, false), Finish::diffuse, 0.88},
             {trough({{0.03, 0}, {0.03, 0.06}}, 1.2, true, false), Finish::diffuse, 0.88},
             {rectangle({0, 0, 0.04}, {0.03, 0, 0}, {0, 0.6, 0}), Finish::diffuse, 0.85},
             {rectangle({0, 0, 0.0001}, {0.0299, 0, 0}, {0, 0.6, 0}), Finish::diffuser, 0.4, 0.55},
             {quads({{-0.03, -0.6, 0},
                     {0.03, -0.6, 0},
                     {0.03, -0.6, 0.06},
                     {-0.03, -0.6, 0.06},
                     {-0.03, 0.6, 0},
                     {0.03, 0.6, 0},
                     {0.03, 0.6, 0.06},
                     {-0.03, 0.6, 0.06}}),
              Finish::diffuse, 0.88}};
  f.lamps = {{.kind = Lamp::Kind::rectangle,
              .center = {0, 0, 0.0399},
              .normal = {0, 0, -1},
              .along = {0, 1, 0},
              .length = 1.18,
              .width = 0.03,
              .share = 0.55},
             {.kind = Lamp::Kind::rectangle,
              .center = {0, 0, 0.0401},
              .normal = {0, 0, 1},
              .along = {0, 1, 0},
              .length = 1.18,
              .width = 0.03,
              .share = 0.45}};
  return f;
}

}  // namespace

std::vector<Fixture> fixtures() {
  return {parabolicDownlight(),
          baffleDownlight(),
          troughBatten(),
          louvre(),
          wallWasher(),
          highBay(),
          opalBox(),
          bollard(),
          cove(),
          spotWithDoors(),
          pendant()};
}

}  // namespace goniolux::traced
