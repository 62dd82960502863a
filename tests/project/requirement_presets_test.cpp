// Requirements by the name of a standard's entry, and grids with a border and the spacing of EN 12464-1.
#include "project/requirement_presets.h"

#include <gtest/gtest.h>

#include "project/project.h"
#include "project_fixture.h"
#include "support/temporary_folder.h"

namespace goniolux::project {
namespace {

std::string roomWith(const std::string& grid, const std::string& requirement) {
  return R"({ "format": "goniolux-project", "version": 1, "name": "presets", "units": "m",
    "materials": { "grey": { "model": "lambert", "diffuse": 0.5 } },
    "objects": [ { "name": "room", "shape": "box", "min": [0,0,0], "max": [6,4,3], "facing": "inward", "material": "grey" } ],
    "luminaires": [ { "name": "L", "photometry": "isotropic", "flux": 1000, "position": [3,2,2.5] } ],
    "grids": [ { "name": "g", "origin": [0,0,0.8], "u": [6,0,0], "v": [0,4,0], )" +
         grid + R"( } ], "requirements": [ )" + requirement + " ] }";
}

Project read(const std::string& text) {
  const test::TemporaryFolder folder;
  folder.write("project.json", text);
  return readProject(folder.path().string());
}

// p = 0.2 · 5^(log10 d): 0.2 m at 1 m, 1 m at 10 m, 5 m at 100 m exactly; never above 10 m.
TEST(En12464Grid, SpacingFollowsTheFormula) {
  EXPECT_NEAR(en12464Spacing(1), 0.2, 1e-12);
  EXPECT_NEAR(en12464Spacing(10), 1, 1e-12);
  EXPECT_NEAR(en12464Spacing(100), 5, 1e-12);
  EXPECT_EQ(en12464Spacing(1e6), 10);
}

// 6 m x 4 m: d = 6 m, p = 0.2 · 5^0.778 = 0.700 m, 6/0.700 = 8.6: nine spacings of 0.667 m; 4/0.667 = 6.
// 20 m x 2 m: more than twice as long, so d = 2 m, p = 0.325 m, six spacings of 0.333 m; 20/0.333 = 60.
TEST(En12464Grid, CountsFollowTheLongerEdgeUnlessItIsTwiceAsLong) {
  EXPECT_EQ(en12464Counts(6, 4), (std::array{9, 6}));
  EXPECT_EQ(en12464Counts(4, 6), (std::array{6, 9}));
  EXPECT_EQ(en12464Counts(20, 2), (std::array{60, 6}));
  EXPECT_EQ(en12464Counts(10, 10), (std::array{10, 10}));
}

TEST(En12464Grid, BorderIsTakenOffAllFourEdgesBeforePointsAreCounted) {
  const Project project = read(roomWith(R"("spacing": "EN 12464-1", "border": 0.5)", ""));
  const analysis::Grid& grid = project.grids.at(0);
  EXPECT_EQ(grid.origin, core::Vec3(0.5, 0.5, 0.8));
  EXPECT_NEAR(grid.u.x, 5, 1e-12);
  EXPECT_NEAR(grid.v.y, 3, 1e-12);
  EXPECT_EQ(*grid.counts, en12464Counts(5, 3));
  EXPECT_THROW(read(roomWith(R"("counts": [3,3], "border": 2)", "")), core::InputError);
  EXPECT_THROW(read(roomWith(R"("counts": [3,3], "spacing": "EN 12464-1")", "")), core::InputError);
}

TEST(RequirementPresets, AreSoundData) {
  ASSERT_GE(requirementPresets().size(), 20U);
  for (const RequirementPreset& preset : requirementPresets()) {
    EXPECT_FALSE(preset.clause.empty()) << preset.name;
    EXPECT_FALSE(presetLimits(preset, "task").empty()) << preset.name;
    const double ugr = preset.ugr.value_or(19);
    EXPECT_TRUE(ugr >= 13 && ugr <= 28) << preset.name;  // the scale of CIE 117
    for (const auto& share : {preset.u0, preset.ud}) EXPECT_TRUE(!share || (*share > 0 && *share < 1)) << preset.name;
  }
}

TEST(RequirementPresets, GiveTheLimitsOfAnOfficeWithTheirClause) {
  const Project project = read(roomWith(R"("counts": [3,3])",
                                        R"({ "preset": "en-12464-1:34.2", "grid": "g" },
       { "preset": "en-12464-1:34.2", "grid": "g", "area": "surrounding" },
       { "preset": "en-12464-1:34.2", "grid": "g", "area": "background" },
       { "preset": "en-1838:open-area", "grid": "g", "max_lx": { "max": 100 } })"));
  ASSERT_EQ(project.requirements.size(), 5U);
  const auto limit = [&](std::size_t index, const std::string& key) {
    for (const analysis::Limit& l : project.requirements[index].limits)
      if (l.key == key) return l.minimum ? *l.minimum : *l.maximum;
    return -1.0;
  };
  EXPECT_EQ(limit(0, "mean_lx"), 500);
  EXPECT_EQ(limit(0, "u0"), 0.6);
  EXPECT_EQ(limit(0, "ra"), 80);
  EXPECT_EQ(project.requirements[0].clause, "EN 12464-1:2021, table 34, 34.2");
  EXPECT_EQ(limit(1, "mean_lx"), 300);
  EXPECT_EQ(limit(1, "u0"), 0.4);
  EXPECT_EQ(limit(2, "mean_lx"), 100);
  EXPECT_EQ(limit(3, "min_lx"), 0.5);
  EXPECT_EQ(limit(3, "ud"), 0.025);  // 40 to 1
  EXPECT_EQ(limit(4, "max_lx"), 100);
  EXPECT_EQ(project.requirements[3].clause, "EN 1838:2013, 4.3.1, 4.3.2");
  EXPECT_TRUE(project.requirements[4].clause.empty()) << "the project's own limit is no clause of a standard";
}

TEST(RequirementPresets, SayBesideTheVerdictWhereNothingPublicConfirmsTheirFigures) {
  const RequirementPreset* drawing = findRequirementPreset("en-12464-1:34.3");
  ASSERT_NE(drawing, nullptr);
  EXPECT_EQ(drawing->reference(), "EN 12464-1:2021, table 34, 34.3 (figures unconfirmed)");
  std::size_t confirmed = 0;
  for (const RequirementPreset& preset : requirementPresets()) {
    const bool unconfirmed = preset.reference().ends_with("(figures unconfirmed)");
    EXPECT_EQ(unconfirmed, preset.comparedWith.empty()) << preset.name;
    confirmed += unconfirmed ? 0 : 1;
  }
  EXPECT_GE(confirmed, 9U);
}

TEST(RequirementPresets, UnknownNamesAndAreasWithoutALimitAreRefusedAtTheirPlace) {
  for (const char* requirement : {R"({ "preset": "en-12464-1:99.9", "grid": "g" })",
                                  R"({ "preset": "en-1838:open-area", "grid": "g", "area": "wall" })",
                                  R"({ "grid": "g", "area": "wall", "u0": { "min": 0.1 } })"}) {
    try {
      read(roomWith(R"("counts": [3,3])", requirement));
      ADD_FAILURE() << requirement;
    } catch (const core::InputError& error) {
      EXPECT_GT(error.diagnostics().all().at(0).position.line, 0) << requirement;
    }
  }
}

}  // namespace
}  // namespace goniolux::project
