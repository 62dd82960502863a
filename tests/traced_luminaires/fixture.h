// A modelled luminaire: lamps, and reflectors, diffusers and shields about them. Luminaire frame as in the world: C0 =
// +x, C90 = +y, aim = -z; metres.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/vector.h"
#include "geometry/shape.h"
#include "photometry/photometric_file.h"

namespace goniolux::traced {

/// What light does at a surface.
enum class Finish {
  mirror,    ///< reflects in one direction
  diffuse,   ///< Lambertian, on the side that was hit
  diffuser,  ///< Lambertian on both sides: reflects and transmits
  black
};

struct Part {
  geometry::Shape shape;
  Finish finish = Finish::diffuse;
  double reflectance = 0.85, transmittance = 0;
};

/// A Lambertian source of light. Its own body is a part of its own.
struct Lamp {
  enum class Kind { disc, rectangle, tube, sphere };
  Kind kind = Kind::disc;
  core::Vec3 center{0}, normal{0, 0, -1};      ///< of flat lamps: where they shine
  core::Vec3 along{1, 0, 0};                   ///< of rectangles and tubes
  double length = 0, width = 0, diameter = 0;  ///< m
  double share = 1;                            ///< of the lamp flux
};

struct Fixture {
  std::string file;             ///< the file's name; its ending is its format
  std::string title, use, how;  ///< for the library's page
  double lampFlux = 1000, watts = 10;
  bool absolute = true;  ///< LED: the luminaire's own flux; else relative to its lamps
  std::string lamp;      ///< the lamp's name
  std::string spectrum;  ///< what a project gives as "spectrum" with it
  photometry::StatedOpening opening;
  std::vector<double> planes, gammas;  ///< of the table, degrees; the planes' range tells the symmetry
  std::vector<Part> parts;
  std::vector<Lamp> lamps;
};

/// All fixtures that are traced for luminaires/.
std::vector<Fixture> fixtures();

}  // namespace goniolux::traced
