#include "pipeline/result_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/document.h"
#include "plot/vtp.h"
#include "project/summary_table.h"

namespace goniolux::pipeline {
namespace {

using plot::PolyData;
using project::GridResult;
using project::Results;

std::string underscored(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == ' '; }, '_');
  return name;
}

/// The points with value, half-width and its parts, as a surface between them.
PolyData polyDataOf(const Results& results, const GridResult& grid) {
  PolyData data;
  data.comment =
      fmt::format("goniolux {}: {} of grid {} of project {}, hash {}, seed {}, half-widths at {:g} % confidence",
                  results.programVersion, grid.quantity, grid.name, results.project, results.projectHash, results.seed,
                  100 * results.confidence);
  data.points = grid.points;
  const std::string unit = grid.unit.empty() ? "" : "_" + grid.unit;
  data.pointData.push_back({underscored(grid.quantity) + unit, grid.values});
  data.pointData.push_back({"half_width" + unit, grid.halfWidths});
  for (const auto& [cause, halfWidths] : grid.parts) {
    data.pointData.push_back({"half_width_" + underscored(cause) + unit, halfWidths});
  }
  if (!grid.counts) {
    for (std::int64_t i = 0; i < std::ssize(grid.points); ++i) data.vertices.push_back({i});
    return data;
  }
  const std::int64_t nu = (*grid.counts)[0], nv = (*grid.counts)[1];
  std::vector<bool> isExcluded(grid.points.size(), false);
  for (const std::size_t i : grid.excluded) isExcluded[i] = true;
  for (std::int64_t j = 0; j + 1 < nv; ++j) {
    for (std::int64_t i = 0; i + 1 < nu; ++i) {
      const std::vector<std::int64_t> cell{j * nu + i, j * nu + i + 1, (j + 1) * nu + i + 1, (j + 1) * nu + i};
      const bool whole = std::none_of(
          cell.begin(), cell.end(), [&](std::int64_t corner) { return isExcluded[static_cast<std::size_t>(corner)]; });
      if (whole) data.polygons.push_back(cell);
    }
  }
  if (nu == 1 || nv == 1) {  // a row of points
    std::vector<std::int64_t> row;
    for (std::int64_t i = 0; i < nu * nv; ++i) row.push_back(i);
    data.lines.push_back(std::move(row));
  }
  return data;
}

}  // namespace

std::string gridVtp(const Results& results, const GridResult& grid) {
  return plot::vtpOf(polyDataOf(results, grid));
}

std::string gridVtu(const Results& results, const GridResult& grid) {
  return plot::vtuOf(polyDataOf(results, grid));
}

std::string outlineVtp(const Outline& outline) {
  PolyData data;
  data.comment = fmt::format("goniolux: outline of project {}, hash {}", outline.project, outline.projectHash);
  PolyData::Array kind{"kind (0 room, 1 object, 2 luminaire)", {}};
  const auto add = [&](const core::Vec3& point, double what) {
    data.points.push_back(point);
    kind.values.push_back(what);
    return std::ssize(data.points) - 1;
  };
  for (const ObjectOutline& object : outline.objects) {
    for (const Segment& edge : object.edges) {
      const double what = object.isRoom ? 0 : 1;
      const std::int64_t from = add(edge.from, what);
      data.lines.push_back({from, add(edge.to, what)});
    }
  }
  for (const LuminaireOutline& luminaire : outline.luminaires) {
    if (luminaire.footprint.size() < 2) {
      data.vertices.push_back({add(luminaire.position, 2)});
      continue;
    }
    std::vector<std::int64_t> line;
    for (const core::Vec3& corner : luminaire.footprint) line.push_back(add(corner, 2));
    if (line.size() > 2) line.push_back(line.front());
    data.lines.push_back(std::move(line));
  }
  data.pointData.push_back(std::move(kind));
  return plot::vtpOf(data);
}

std::vector<std::string> writeResultFiles(const std::string& folder, const Results& results, const Outline& outline) {
  const std::filesystem::path base = folder;
  std::error_code error;
  std::filesystem::create_directories(base, error);
  if (error) throw core::RunError(fmt::format("{}: the folder cannot be made: {}", folder, error.message()));

  std::vector<std::string> files;
  const auto write = [&](const std::string& name, const std::string& content,
                         core::Durability durability = core::Durability::whenConvenient) {
    const std::string file = (base / name).string();
    if (std::find(files.begin(), files.end(), file) != files.end())
      return;  // a grid may be called "outline": it goes first
    core::writeFile(file, content, durability);
    files.push_back(file);
  };
  for (const GridResult& grid : results.grids) {
    const std::string name = project::fileNameFor(grid.name);
    write(name + ".csv", project::toCsv(results, grid));
    write(name + ".vtp", gridVtp(results, grid));
  }
  write(outlineFileName, core::toJson(toJson(outline)));
  write("outline.vtp", outlineVtp(outline));
  write(project::summaryFileName, project::toSummaryTable(results));
  // Last, so that a folder that has it has everything; all others repeat what it says.
  write(project::resultsFileName, core::toJson(project::toJson(results)), core::Durability::toTheDisk);
  return files;
}

}  // namespace goniolux::pipeline
