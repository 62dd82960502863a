// Report: what a designer hands to a client, as one HTML file that a browser shows and a printer of HTML turns into
// PDF: cover, requirements, luminaires, plan, results with intervals, renderings, and how it was calculated. In two
// languages and two systems of units. Input is metric and in lx; nothing is calculated here but conversions.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/vector.h"
#include "plot/figure.h"
#include "plot/polar.h"
#include "project/results.h"

namespace goniolux::report {

enum class Language { english, german };
enum class Units { metric, imperial };

struct Picture {
  std::string name;
  std::string mimeType;  ///< "image/png", "image/svg+xml"
  std::string bytes;
};

/// A luminous opening as the photometric file states it.
struct Opening {
  std::string shape;                                   ///< "rectangle", "upright cylinder"; "" = not known
  double alongC0_m = 0, alongC90_m = 0, height_m = 0;  ///< 0 = none
};

/// A luminaire of the schedule: all that come from one entry of the project.
struct LuminaireType {
  std::string letter;  ///< "A", as in the plan
  std::string name;    ///< of the project's entry
  std::string product, maker, catalogue, file;
  bool isFile = true;  ///< `file` is one; else a distribution that the program knows by name
  Opening opening;
  int count = 0;
  double flux_lm = 0, watts = 0;  ///< of one; watts 0 = not stated
  double maintenance = 1, dimming = 1;
  double maximum_cd = 0, downwardShare = 1;
  /// Full widths in C0-C180 and in C90-C270.
  std::optional<double> beamC0_deg, beamC90_deg, fieldC0_deg, fieldC90_deg;
  std::optional<double> cct_K, ra;  ///< empty where the spectrum is not stated, or is none of a white
  std::optional<plot::PolarDiagram> polar;
  std::vector<core::Vec3> positions;  ///< m
};

struct Surface {
  std::string object, part, material;
  double reflectance = 0;  ///< luminous, for an equal-energy spectrum
};

/// The plan: lines in metres, x to the right.
struct Plan {
  std::vector<plot::Polyline> roomLines, objectLines;
  struct Symbol {
    std::string letter;
    core::Vec2 position{0};
    plot::Polyline footprint;
  };
  std::vector<Symbol> luminaires;
  struct Area {
    std::string name;
    plot::Polyline corners;
  };
  std::vector<Area> grids;
};

/// What one group of luminaires gives, at the level of these results.
struct Contribution {
  std::string group;
  double level = 1;
  std::vector<core::Estimate> means;  ///< one per grid, in its unit
};

struct Report {
  project::Results results;
  std::string date;  ///< as it is to be read
  std::vector<LuminaireType> luminaires;
  std::vector<Surface> surfaces;
  std::optional<core::Vec3> roomSize;  ///< m, of the box around the scene
  std::optional<double> floorArea_m2;
  std::optional<Plan> plan;
  std::vector<std::optional<Picture>> maps;  ///< one per grid, in the chosen units and language
  std::vector<Picture> renderings;
  std::vector<Contribution> contributions;  ///< empty where the groups were not calculated one by one
  std::optional<Picture> speedChart;        ///< error over time, where the project was studied
  std::vector<std::string> remarks;         ///< what a reader must know: stale results, missing pictures
  Language language = Language::english;
  Units units = Units::metric;
};

/// The whole report as one HTML document with everything in it.
std::string htmlOf(const Report& report);

}  // namespace goniolux::report
