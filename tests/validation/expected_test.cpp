// Every project in projects/ that has an expected.json, at 3 %, against the values there: closed forms, radiosity and
// other programs, as the file says. Our interval and the expected one must meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/document.h"
#include "core/progress.h"
#include "pipeline/engine.h"
#include "pipeline/illuminate.h"

namespace goniolux {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> projectsWithExpectations() {
  std::vector<std::string> found;
  const fs::path root = fs::path(GONIOLUX_SOURCE_DIR) / "projects";
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.path().filename() == "expected.json")
      found.push_back(fs::relative(entry.path().parent_path(), root).string());
  std::sort(found.begin(), found.end());
  return found;
}

class ExpectedValues : public testing::TestWithParam<std::string> {};

TEST_P(ExpectedValues, AreMetWithinBothIntervals) {
  const fs::path folder = fs::path(GONIOLUX_SOURCE_DIR) / "projects" / GetParam();
  const std::string file = (folder / "expected.json").string();
  core::Diagnostics diagnostics;
  const core::Value expected = core::parseJson(core::readFile(file), file, diagnostics);
  ASSERT_FALSE(diagnostics.hasErrors());

  pipeline::StageRequest request;
  request.inputs = {folder.string()};
  request.common.accuracy = "3 %";
  const project::Project project = pipeline::readProjectFor(request, pipeline::AccuracyOf::grids);
  const pipeline::Engine engine(project, false);
  core::SilentProgress silent;
  const project::Results results = pipeline::calculateGrids(project, engine, silent);

  int compared = 0, beyond = 0;
  for (const core::Value& entry : expected.find("values")->array()) {
    const std::string gridName = entry.find("grid")->string(), quantity = entry.find("quantity")->string();
    const double value = entry.find("value")->number(), halfWidth = entry.find("half_width")->number();
    for (const project::GridResult& grid : results.grids) {
      if (grid.name != gridName) continue;
      core::Estimate ours;
      if (quantity == "mean")
        ours = grid.mean;
      else if (quantity == "min")
        ours = grid.min;
      else if (quantity == "max")
        ours = grid.max;
      else if (quantity == "u0")
        ours = grid.u0;
      else if (quantity == "ud")
        ours = grid.ud;
      else if (quantity == "point") {
        const auto index = static_cast<std::size_t>(entry.find("index")->number());
        ours.value = grid.values.at(index);
        ours.statistical = grid.halfWidths.at(index);
      } else {
        ADD_FAILURE() << "expected.json names an unknown quantity " << quantity;
      }
      ++compared;
      const double allowed = ours.halfWidth() + halfWidth;
      if (std::abs(ours.value - value) <= allowed) continue;
      ++beyond;
      // 95 % intervals part now and then; by twice their width they do not.
      EXPECT_LE(std::abs(ours.value - value), 2 * allowed)
          << gridName << " " << quantity << ": ours " << ours.value << " ± " << ours.halfWidth() << ", expected "
          << value << " ± " << halfWidth;
    }
  }
  EXPECT_GT(compared, 0);
  EXPECT_LE(beyond, std::max(1, compared / 10)) << "of " << compared << " values";
}

INSTANTIATE_TEST_SUITE_P(Projects, ExpectedValues, testing::ValuesIn(projectsWithExpectations()),
                         [](const auto& parameter) {
                           std::string name = parameter.param;
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

}  // namespace
}  // namespace goniolux
