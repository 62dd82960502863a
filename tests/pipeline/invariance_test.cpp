// A room that is moved or scaled is lit as before: illuminances agree to 1e-4, with the same random numbers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

// A furnished room, all lengths times `scale` and moved by `shift`; flux grows with area, so that illuminance stays.
std::vector<double> illuminances(double scale, double shift) {
  const auto p = [&](double x, double y, double z) {
    return fmt::format("[{},{},{}]", x * scale + shift, y * scale - 2 * shift, z * scale + 0.1 * shift);
  };
  const auto v = [&](double x, double y, double z) {
    return fmt::format("[{},{},{}]", x * scale, y * scale, z * scale);
  };
  const std::string project = fmt::format(
      "{{ \"format\": \"goniolux-project\", \"version\": 1, \"materials\": {{ \"grey\": {{ \"model\": \"lambert\", "
      "\"diffuse\": 0.5 }} }},\n\"objects\": [\n{{ \"shape\": \"box\", \"min\": {}, \"max\": {}, \"facing\": "
      "\"inward\", "
      "\"material\": \"grey\" }},\n{{ \"shape\": \"box\", \"min\": {}, \"max\": {}, \"material\": \"grey\" }},\n{{ "
      "\"shape\": \"sphere\", \"center\": {}, \"radius\": {}, \"material\": \"grey\" }},\n{{ \"shape\": \"torus\", "
      "\"center\": {}, \"ring_radius\": {}, \"tube_radius\": {}, \"material\": \"grey\" }} ],\n\"luminaires\": [ {{ "
      "\"photometry\": \"cosine\", \"flux\": {}, \"position\": {}, \"shape\": {{ \"rectangle\": {{ \"length\": {}, "
      "\"width\": {} }} }} }} ],\n\"grids\": [ {{ \"name\": \"plane\", \"origin\": {}, \"u\": {}, \"v\": {}, "
      "\"counts\": "
      "[6,4], \"normal\": [0,0,1] }} ],\n\"settings\": {{ \"accuracy\": {{ \"grid\": \"5 %\" }}, \"seed\": 5 }} }}\n",
      p(0, 0, 0), p(6, 4, 3), p(2, 1, 0), p(3.5, 1.8, 0.75), p(4.5, 2.5, 1.2), 0.4 * scale, p(1.3, 2.7, 1), 0.5 * scale,
      0.1 * scale, 4000 * scale * scale, p(3, 2, 2.9), 0.6 * scale, 0.6 * scale, p(0, 0, 0.8), v(6, 0, 0), v(0, 4, 0));
  const test::TemporaryFolder folder;
  folder.write("project.json", project);
  core::SilentProgress silent;
  StageRequest request;
  request.inputs = {folder.path().string()};
  const StageReport report = illuminateStage().run(request, silent);
  std::vector<double> values;
  for (const core::Value& value : report.json.find("grids")->array().front().find("values")->array())
    values.push_back(value.number());
  return values;
}

TEST(Invariance, ScaleAndPlaceLeaveIlluminanceAsItIs) {
  const auto reference = illuminances(1, 0);
  ASSERT_EQ(reference.size(), 24U);
  for (const auto& [scale, shift] :
       std::vector<std::pair<double, double>>{{1, 1e4}, {1, 1e6}, {1e-2, 0}, {1e2, 0}, {1e2, 1e5}}) {
    const auto moved = illuminances(scale, shift);
    double mean = 0, before = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) mean += moved[i], before += reference[i];
    std::printf("scale %g, moved by %g m: mean changes by %.2g\n", scale, shift, mean / before - 1);
    EXPECT_NEAR(mean / before, 1, 1e-4) << "scale " << scale << " shift " << shift;
  }
}

}  // namespace
}  // namespace goniolux::pipeline
