#include "analysis/ugr_table.h"

#include <cmath>

#include "analysis/position_index.h"

namespace goniolux::analysis {

using core::Vec3;

double GlareSource::projectedArea(const Vec3& local) const {
  const Vec3 d = glm::abs(local);
  if (!round) return extent.x * extent.y * d.z + extent.y * extent.z * d.x + extent.x * extent.z * d.y;
  return 0.25 * core::pi * extent.x * extent.y * d.z + extent.z * std::hypot(extent.y * d.x, extent.x * d.y);
}

double glareSum(const GlareSource& source, const GlareGrid& grid, bool fieldLimits) {
  const Vec3 forward(0, 1, 0), up(0, 0, 1), aim(0, 0, -1);
  const photometry::LuminaireFrame frame{grid.c0, glm::cross(grid.c0, aim), aim};
  double sum = 0;
  for (int i = 0; i < grid.across; ++i)
    for (int j = 0; j < grid.along; ++j) {
      const Vec3 at(grid.firstAcross + i * grid.step, grid.firstAlong + j * grid.step, grid.height);
      if (!(at.y > 0)) continue;
      if (fieldLimits && (grid.height > 1.9 * at.y * (1 + 1e-9) || std::abs(at.x) > 3 * at.y * (1 + 1e-9))) continue;
      const double squared = glm::dot(at, at);
      const Vec3 toSource = at / std::sqrt(squared), local = frame.toLocal(-toSource);
      const double area = source.projectedArea(local);
      if (!(area > 0)) continue;
      const double luminance = source.distribution->intensity(local) / area;
      const double p = positionIndex(forward, up, toSource);
      sum += luminance * luminance * (area / squared) / (p * p);
    }
  return sum;
}

double ugr(double sum, double backgroundLuminance) {
  return 8 * std::log10(0.25 / backgroundLuminance * sum);
}

std::optional<UgrTable> ugrTable(const GlareSource& source) {
  const double down = source.distribution->forwardFlux(), up = source.distribution->flux() - down;
  if (!(down + up > 0) || !(source.projectedArea({0, 0, 1}) > 0)) return std::nullopt;
  constexpr double spacing = 0.25;
  UgrTable table;
  for (std::size_t room = 0; room < UgrTable::rooms.size(); ++room) {
    const double x = UgrTable::rooms[room][0], y = UgrTable::rooms[room][1];  // H = 1 m
    for (const bool crosswise : {true, false}) {
      GlareGrid grid;
      grid.across = static_cast<int>(std::lround(x / spacing));
      grid.along = static_cast<int>(std::lround(y / spacing));
      grid.firstAcross = -0.5 * x + 0.5 * spacing;
      grid.firstAlong = 0.5 * spacing;
      grid.step = spacing;
      grid.height = 1;
      grid.c0 = crosswise ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
      const double sum = glareSum(source, grid, true);
      // C0 lies along the cavity's length.
      const Cavity cavity = crosswise ? Cavity{y, x} : Cavity{x, y};
      const double ratio = directRatio(*source.distribution, cavity), f = floorToCeiling(cavity);
      const double luminaires = grid.across * grid.along, floorArea = x * y, wallArea = 2 * (x + y);
      for (std::size_t r = 0; r < UgrTable::reflectances.size(); ++r) {
        const CavityFlux first{up, (1 - ratio) * down, ratio * down};
        const CavityFlux all = exchange(first, f, wallArea / floorArea, UgrTable::reflectances[r]);
        const double indirect = luminaires * (all.walls - first.walls) / wallArea;
        const double value = sum > 0 ? ugr(sum, indirect / core::pi) : 0;
        (crosswise ? table.crosswise : table.endwise)[room][r] = value;
      }
    }
  }
  return table;
}

}  // namespace goniolux::analysis
