// The reference rooms R1, R2 and R4 at 1 % against grids of an independent path tracer (validation/rooms of the shared
// folder): at least 93 % of the points inside their 95 % interval, RMS error at most 0.6 %, mean within 0.15 %. Prints
// the CPU time beside what other programs need (validation/peers.md, least CPU seconds for 1 % RMS).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "core/progress.h"
#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "support/shared_folder.h"

namespace goniolux {
namespace {

struct Room {
  const char* name;
  double radiance_s, naive_s;  // peers.md: Radiance's best setting, and a plain path tracer with 256 paths per point
};
void PrintTo(const Room& room, std::ostream* out) {
  *out << room.name;
}

struct Reference {
  double value, standardError;
};

std::map<std::pair<long, long>, Reference> readGrid(const std::filesystem::path& file) {
  std::map<std::pair<long, long>, Reference> grid;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::stringstream fields(line);
    std::vector<double> row;
    for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
    grid[{std::lround(row[2] * 1000), std::lround(row[3] * 1000)}] = {row[5], row[6]};
  }
  return grid;
}

class ReferenceRoom : public testing::TestWithParam<Room> {};

TEST_P(ReferenceRoom, IsMetAtOnePercent) {
  const auto shared = test::sharedFolder();
  if (!shared) GTEST_SKIP() << test::sharedFolderIsAbsent;
  const Room room = GetParam();
  const auto reference = readGrid(*shared / "validation/rooms" / (std::string(room.name) + ".csv"));

  pipeline::StageRequest request;
  request.inputs = {std::string(GONIOLUX_SOURCE_DIR) + "/projects/validation/" + room.name};
  request.common.accuracy = "1 %";
  const project::Project project = pipeline::readProjectFor(request, pipeline::AccuracyOf::grids);
  const pipeline::Engine engine(project, false);
  core::SilentProgress silent;
  const project::Results results = pipeline::calculateGrids(project, engine, silent);
  ASSERT_TRUE(results.reached);

  const project::GridResult& grid = results.grids.at(0);
  std::size_t points = 0, inside = 0;
  double squares = 0, largest = 0, sum = 0, referenceSum = 0;
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    if (std::isnan(grid.values[i])) continue;
    const auto found = reference.find({std::lround(grid.points[i].x * 1000), std::lround(grid.points[i].y * 1000)});
    ASSERT_NE(found, reference.end());
    const Reference& r = found->second;
    const double error = grid.values[i] - r.value;
    ++points;
    inside += std::abs(error) <= std::hypot(grid.halfWidths[i], 1.96 * r.standardError);
    squares += error * error / (r.value * r.value);
    largest = std::max(largest, std::abs(error) / r.value);
    sum += grid.values[i];
    referenceSum += r.value;
  }
  const auto n = static_cast<double>(points);
  const double coverage = static_cast<double>(inside) / n, rms = std::sqrt(squares / n), bias = sum / referenceSum - 1;
  std::printf(
      "%s: %zu points, %.1f %% inside, RMS %.3f %%, largest %.2f %%, mean %+.3f %%; %.2f CPU s (Radiance %.2f, plain "
      "path tracer %.2f)\n",
      room.name, points, 100 * coverage, 100 * rms, 100 * largest, 100 * bias, results.cpuTime_s, room.radiance_s,
      room.naive_s);
  EXPECT_EQ(points, reference.size());
  EXPECT_GE(coverage, 0.93);
  EXPECT_LE(rms, 0.006);
  EXPECT_LE(std::abs(bias), 0.0015);
}

INSTANTIATE_TEST_SUITE_P(Rooms, ReferenceRoom,
                         testing::Values(Room{"R1", 0.67, 0.22}, Room{"R2", 1.6, 0.31}, Room{"R4", 0.96, 0.36}),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace goniolux
