#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "photometry/metrics.h"
#include "photometry/transform.h"
#include "photometry/writers.h"

namespace goniolux::photometry {
namespace {

std::string keyword(const PhotometricFile& file, const char* key, const char* otherKey = "") {
  for (const char* name : {key, otherKey})
    if (const auto found = file.keywords.find(name); found != file.keywords.end())
      return found->second.substr(0, found->second.find('\n'));
  return "";
}

/// The planes as EULUMDAT stores them, and the full list that its counts refer to.
struct Storage {
  int symmetry = 0;
  std::vector<double> listed;
  std::vector<std::vector<double>> stored;
};

bool isNear(double a, double b) {
  return std::abs(a - b) < 1e-6;
}

// The planes of a full circle, its symmetry code, and those that are stored.
Storage storageOf(const TabulatedDistribution& d, core::Diagnostics& warnings, const std::string& file) {
  PlaneTable all = allPlanes(d);
  Storage storage;
  if (d.symmetry() == HorizontalSymmetry::rotational) return {1, {0}, {all.candelas.front()}};
  if (all.candelas.back() != all.candelas.front()) {
    warnings.warning({file, 0, 0}, "seam-lost",
                     "planes 0 and 360 differ, EULUMDAT has plane 0 alone: plane 360 is left out");
  }
  all.planes.pop_back();
  all.candelas.pop_back();
  storage.listed = all.planes;
  const std::size_t count = all.planes.size();
  const auto store = [&](int symmetry, std::size_t first, std::size_t planes) {
    storage.symmetry = symmetry;
    for (std::size_t i = 0; i < planes; ++i) storage.stored.push_back(all.candelas[(first + i) % count]);
  };
  const bool quarters = count % 4 == 0 && isNear(all.planes[count / 4], 90) && isNear(all.planes[count / 2], 180) &&
                        isNear(all.planes[3 * count / 4], 270);
  switch (d.symmetry()) {
    case HorizontalSymmetry::quadrant:
      if (quarters) {
        store(4, 0, count / 4 + 1);
        return storage;
      }
      break;
    case HorizontalSymmetry::aboutC0:
      if (count % 2 == 0 && isNear(all.planes[count / 2], 180)) {
        store(2, 0, count / 2 + 1);
        return storage;
      }
      break;
    case HorizontalSymmetry::aboutC90:
      if (quarters) {
        store(3, 3 * count / 4, count / 2 + 1);
        return storage;
      }
      break;
    default:
      break;
  }
  store(0, 0, count);
  return storage;
}

// The shortest number near `candela / factor` that gives `candela` when multiplied, if there is one.
double relative(double candela, double factor) {
  const double quotient = candela / factor;
  if (quotient * factor == candela) return quotient;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double target : {infinity, -infinity}) {
    double near = quotient;
    for (int i = 0; i < 2; ++i) {
      near = std::nextafter(near, target);
      if (near * factor == candela) return near;
    }
  }
  return quotient;
}

double equalStep(const std::vector<double>& angles, double whole) {
  if (angles.size() < 2) return 0;
  const double step = angles[1] - angles[0];
  for (std::size_t i = 1; i < angles.size(); ++i)
    if (!isNear(angles[i] - angles[i - 1], step)) return 0;
  return whole > 0 && !isNear(step * static_cast<double>(angles.size()), whole) ? 0 : step;
}

class Writer {
 public:
  Writer(const PhotometricFile& file, core::Diagnostics& warnings) : file_(file), warnings_(warnings) {}

  std::string write() {
    const TabulatedDistribution& d = *file_.distribution;
    if (d.type() != PhotometryType::c) {
      throw core::InputError({file_.file, 0, 0}, "not-supported",
                             "EULUMDAT has no photometry types A and B; write the file as .ies");
    }
    const Storage storage = storageOf(d, warnings_, file_.file);
    const double lampFlux = file_.declaredLumens.value_or(d.flux() > 0 ? d.flux() : 1000);
    line(keyword(file_, "MANUFAC"));
    line(storage.symmetry == 1 ? 1 : file_.opening.length > 3 * file_.opening.width ? 2 : 3);  // Ityp
    line(storage.symmetry);
    line(static_cast<double>(storage.listed.size()));
    line(equalStep(storage.listed, 360));
    line(static_cast<double>(d.verticalAngles().size()));
    line(equalStep(d.verticalAngles(), 0));
    line(keyword(file_, "TEST"));
    line(keyword(file_, "LUMINAIRE"));
    line(keyword(file_, "LUMCAT"));
    line(keyword(file_, "FILENAME"));
    line(keyword(file_, "DATE", "ISSUEDATE"));
    writeOpening();
    const double flux = d.flux();
    line(flux > 0 ? 100 * d.forwardFlux() / flux : 100);  // downward flux fraction
    line(file_.lightOutputRatio ? 100 * *file_.lightOutputRatio : 100 * flux / lampFlux);
    line(1);  // conversion factor
    line(0);  // tilt
    line(1);  // lamp sets
    line(file_.absolute || !file_.declaredLumens ? -1 : 1);
    line(keyword(file_, "LAMP"));
    line(lampFlux);
    line(keyword(file_, "COLOUR", "_COLOUR"));
    line(keyword(file_, "COLOURRENDERING", "_COLOURRENDERING"));
    line(file_.inputWatts);
    for (int i = 0; i < 10; ++i) line(0);  // direct ratios: readers calculate them from the table
    for (const double c : storage.listed) line(c);
    for (const double gamma : d.verticalAngles()) line(gamma);
    const double factor = 1 * lampFlux / 1000;  // as the reader multiplies
    for (const auto& plane : storage.stored)
      for (const double candela : plane) line(relative(candela, factor));
    return text_;
  }

 private:
  void line(const std::string& words) { text_ += words + "\r\n"; }
  void line(double number) { text_ += fmt::format("{}\r\n", number); }

  // Housing, then luminous area, in mm; the luminous area is the only one known. Length lies along C90.
  void writeOpening() {
    using Shape = StatedOpening::Shape;
    const StatedOpening& o = file_.opening;
    const auto millimetres = [](double metres) { return std::round(1e6 * metres) / 1000; };
    double length = millimetres(o.lengthAlongC90 ? o.length : o.width),
           width = millimetres(o.lengthAlongC90 ? o.width : o.length), height = millimetres(o.height);
    const bool round = (o.shape == Shape::disc || o.shape == Shape::cylinder) && o.axis == StatedOpening::Axis::aim &&
                       o.length == o.width;
    if (round) width = 0;
    const bool plain = round || o.shape == Shape::point || o.shape == Shape::box ||
                       (o.shape == Shape::rectangle && o.axis == StatedOpening::Axis::aim);
    if (!plain) {
      warnings_.warning({file_.file, 0, 0}, "opening-lost",
                        "EULUMDAT knows no opening of this shape; the box about it is written");
      length = std::max(length, 1.0);
      width = std::max(width, 1.0);
    }
    for (int i = 0; i < 2; ++i) {
      line(length);
      line(width);
      if (i == 0) line(height);
    }
    for (int plane = 0; plane < 4; ++plane) line(height);
  }

  const PhotometricFile& file_;
  core::Diagnostics& warnings_;
  std::string text_;
};

}  // namespace

std::string writeEulumdat(const PhotometricFile& file, core::Diagnostics& warnings) {
  return Writer(file, warnings).write();
}

}  // namespace goniolux::photometry
